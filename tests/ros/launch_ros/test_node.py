"""Node: from its arguments to the command line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext
from launch.actions import GroupAction, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace
from launch_ros.utilities import to_parameters_list

from edulaunch import Session
from edulaunch.engine.facts import facts_of


def drive(**arguments: Any) -> Node:
    return Node(package='robo', executable='drive', **arguments)


@pytest.mark.parametrize(
    ('arguments', 'words'),
    [
        ({}, ['--ros-args']),
        ({'name': 'n'}, ['--ros-args', '-r', '__node:=n']),
        ({'namespace': 'a'}, ['--ros-args', '-r', '__ns:=/a']),
        ({'arguments': ['x', ['y', 'z']], 'name': 'n'}, ['x', 'yz', '--ros-args', '-r', '__node:=n']),
        ({'ros_arguments': ['--log-level', 'debug']}, ['--ros-args', '--log-level', 'debug', '--ros-args']),
        ({'remappings': [('a', 'b'), ('/c', 'd')], 'name': 'n'}, ['--ros-args', '-r', '__node:=n', '-r', 'a:=b', '-r', '/c:=d']),
        (
            {'parameters': [{'p': 1}], 'remappings': [('a', 'b')], 'name': 'n', 'namespace': 's'},
            ['--ros-args', '-r', '__node:=n', '-r', '__ns:=/s', '--params-file', 'PARAMS', '-r', 'a:=b'],
        ),
    ],
)
def test_the_command_line_has_the_order_of_ros(run: Any, arguments: dict[str, Any], words: list[str]) -> None:
    assert run(drive(**arguments)).words == words


# measured: (pushed namespaces, namespace=, the rule for the namespace)
@pytest.mark.parametrize(
    ('pushed', 'given', 'expected'),
    [
        ([], None, None),
        ([], 'a', '/a'),
        ([], '/a', '/a'),
        ([], 'a/b/', '/a/b'),
        ([], '/', '/'),
        ([], '', '/'),
        (['x'], None, '/x'),
        (['x', 'y'], None, '/x/y'),
        (['x', '/y'], None, '/y'),
        (['x'], 'a', '/x/a'),
        (['x'], '/a', '/a'),
        (['x'], '', '/x'),
        ([''], None, '/'),
        (['/'], None, '/'),
    ],
)
def test_namespaces_join_as_in_ros(run: Any, pushed: list[str], given: str | None, expected: str | None) -> None:
    words = run(*map(PushRosNamespace, pushed), drive(namespace=given)).words
    assert words == ['--ros-args', *([] if expected is None else ['-r', f'__ns:={expected}'])]


def test_a_group_ends_a_pushed_namespace(run: Any) -> None:
    specs = run(GroupAction([PushRosNamespace('x'), drive(name='a')]), drive(name='b')).specs
    assert [spec.argv[2:] for spec in specs] == [('-r', '__node:=a', '-r', '__ns:=/x'), ('-r', '__node:=b')]


def test_parameters_of_a_node_with_a_full_name_stand_under_that_name(run: Any) -> None:
    assert run(drive(name='n', namespace='s', parameters=[{'b': 'x', 'a': {'c': [1, 2]}}])).contents == [
        '/s/n:\n  ros__parameters:\n    a.c:\n    - 1\n    - 2\n    b: x\n'
    ]
    assert run(drive(name='n', parameters=[{'b': '1'}])).contents == ["/**:\n  ros__parameters:\n    b: '1'\n"]


def test_generated_files_have_the_same_names_in_every_run_and_differ_within_one(run: Any) -> None:
    def names() -> list[str]:
        nodes = [drive(name=name, parameters=[{'p': 1}, {'p': 1}]) for name in ('a', 'b')]
        return [word for spec in run(*nodes).specs for word in spec.argv if 'launch_params_' in word]

    first = names()
    assert names() == first
    assert len(set(first)) == 4


def test_a_missing_parameter_file_is_skipped_with_a_warning(run: Any) -> None:
    launched = run(drive(parameters=['/no/such.yaml', {'p': 1}]))
    assert launched.words == ['--ros-args', '--params-file', 'PARAMS']
    assert launched.logs == [['WARNING', 'launch_ros.actions.node', 'Parameter file path is not a file: /no/such.yaml']]


def test_the_spec_knows_package_executable_and_where_values_were_written(run: Any) -> None:
    node = drive(parameters=[{'typed': 1, 'given': LaunchConfiguration('speed'), 'mixed': ['a', LaunchConfiguration('who')]}])
    (spec,) = run(SetLaunchConfiguration('speed', '7'), SetLaunchConfiguration('who', 'x'), node).specs
    assert (spec.package, spec.executable, spec.name) == ('robo', 'drive', 'drive-1')
    assert spec.parameter_origins == {
        'typed': f'test_node.py line {node.origin.line}',
        'given': 'launch argument speed',
        'mixed': 'launch argument who',
    }


def test_two_nodes_with_one_full_name_are_noticed(run: Any) -> None:
    logs = run(drive(name='n', namespace='/a'), drive(name='n', namespace='/a')).logs
    assert logs == [
        ['WARNING', 'drive-2', 'there are now at least 2 nodes with the name /a/n created within this launch context']
    ]


@pytest.mark.parametrize(
    ('arguments', 'text'),
    [
        (
            {'name': 'bad name'},
            ("Invalid node name: node name must not contain characters other than alphanumerics or '_':\n  'bad name'\n      ^"),
        ),
        (
            {'namespace': 'bad ns'},
            (
                'Invalid namespace: namespace must not contain characters other than alphanumerics, '
                "'_', or '/':\n  '/bad ns'\n       ^"
            ),
        ),
    ],
)
def test_names_that_no_node_can_have_are_refused_in_the_words_of_rclpy(run: Any, arguments: Any, text: str) -> None:
    launched = run(drive(**arguments))
    assert launched.specs == []
    assert [log[2] for log in launched.logs[:2]] == [
        (
            "Error while expanding or validating node name or namespace for 'package=robo, "
            'executable=drive, '
            f"name={arguments.get('name')}, namespace={arguments.get('namespace')}':"
        ),
        f'Caught exception in launch (see debug for traceback): {text}',
    ]


@pytest.mark.parametrize(
    ('arguments', 'text'),
    [
        (
            {'parameters': {'a': 1}},
            ("'Node' expected 'parameters' to be one of [<class 'list'>], but got '{'a': 1}' of type '<class 'dict'>'"),
        ),
        ({'remappings': ['ab']}, "Expected 'remap_rule' to be one of [<class 'tuple'>], but got 'ab' of type '<class 'str'>'"),
        ({'remappings': [('a', 'b', 'c')]}, 'remap_rule must be a tuple of length 2, got length 3'),
        ({'node_name': 'n'}, "Action.__init__() got an unexpected keyword argument 'node_name'"),
    ],
)
def test_wrong_arguments_are_refused_at_once(arguments: dict[str, Any], text: str) -> None:
    with pytest.raises(TypeError) as caught:
        drive(**arguments)
    assert str(caught.value) == text


def test_node_name_is_known_after_execution_only(run: Any) -> None:
    node = drive(name='n', namespace='s')
    with pytest.raises(RuntimeError, match="cannot access 'node_name' before executing action"):
        assert node.node_name
    run(node)
    assert (node.node_name, node.expanded_node_namespace, node.is_node_name_fully_specified()) == ('/s/n', '/s', True)


def test_without_a_package_the_executable_is_a_command(run: Any) -> None:
    (spec,) = run(Node(executable='drive', name='n')).specs
    assert spec.argv == ('drive', '--ros-args', '-r', '__node:=n')


def test_a_later_source_of_an_xml_file_wins(tmp_path: Path) -> None:
    (tmp_path / 'a.yaml').write_text('/**: {ros__parameters: {a: 2}}')
    (tmp_path / 'talk.py').write_text(
        'import rclpy\nrclpy.init()\nnode = rclpy.create_node("n")\nnode.declare_parameter("a", 0)\n'
        'print(node.get_parameter("a").value)\n'
    )
    (tmp_path / 'a.launch.xml').write_text(
        f'<launch><node exec="python3" args="{tmp_path}/talk.py" output="screen">'
        f'<param name="a" value="1"/><param from="{tmp_path}/a.yaml"/></node></launch>'
    )
    said: list[str] = []
    with Session(env={}, console=lambda stream, text: said.append(text)) as session:
        session.launch(tmp_path / 'a.launch.xml')
        session.run(1.0)
    assert '[python3-1] 2\n' in ''.join(said)


def test_an_empty_file_of_a_composable_node_is_an_error(tmp_path: Path) -> None:
    path = tmp_path / 'empty.yaml'
    path.write_text('')
    with pytest.raises(AttributeError, match="^'NoneType' object has no attribute 'items'$") as caught:
        to_parameters_list(LaunchContext(), 'n', '', (path,))
    assert facts_of(caught.value)['about'] == 'launch.empty-parameter-file'
