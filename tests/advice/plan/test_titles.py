"""The words of a plan: titles, details, and which action has set a value."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from launch.actions import GroupAction, IncludeLaunchDescription, LogInfo, OpaqueFunction, SetEnvironmentVariable
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution

from edulaunch.advice.plan.titles import Branch, Setters, action_words, details_of, shown_value, title_of

PROCESS = {
    'arguments': [],
    'prefix': None,
    'env_changes': {},
    'cwd': None,
    'respawn': False,
    'respawn_delay': None,
    'output': 'log',
}
NODE = {
    'kind': 'node',
    'package': 'p',
    'executable': 'e',
    'namespace': None,
    'runtime_name': None,
    'remappings': [],
    'other_ros_arguments': [],
    **PROCESS,
}


@pytest.mark.parametrize(
    ('item', 'title'),
    [
        ({**NODE, 'runtime_name': '/a/talker'}, 'node /a/talker: p e'),
        (NODE, "node (the program's own name): p e"),
        ({**NODE, 'namespace': '/'}, "node (the program's own name): p e"),
        ({**NODE, 'namespace': ''}, "node (the program's own name): p e"),
        ({**NODE, 'namespace': '/ns', 'package': None}, "node /ns/(the program's own name): e"),
        ({'kind': 'process', 'process_name': 'ls-1', 'cmd': ['ls', '-l']}, 'process ls-1: ls -l'),
        ({'kind': 'load_composable_nodes', 'nodes': [1, 2]}, 'composable nodes to load: 2'),
        ({'kind': 'argument', 'name': 'a', 'value': 'x'}, "argument a = 'x'"),
        ({'kind': 'include', 'file': '/a.launch.py'}, 'include /a.launch.py'),
        ({'kind': 'timer', 'period': 2.50}, 'timer after 2.5 s'),
        ({'kind': 'set_remap', 'from': 'a', 'to': 'b'}, 'remap a -> b for all nodes that follow'),
        ({'kind': 'unset_env', 'name': 'A'}, 'environment A unset'),
        ({'kind': 'reset_configurations'}, 'reset configurations'),
    ],
)
def test_titles(item: dict[str, Any], title: str) -> None:
    assert title_of(item) == title


def details(item: dict[str, Any], **branch: Any) -> list[tuple[str, str]]:
    given: Any = SimpleNamespace(**{'children': [], 'action': SimpleNamespace(respawn_limit=-1), **branch})
    return list(details_of(item, given))


@pytest.mark.parametrize(
    ('change', 'limit', 'found'),
    [
        ({}, -1, []),
        ({'arguments': ['a', 'b']}, -1, [('arguments', 'arguments a b')]),
        ({'prefix': ['xterm', '-e']}, -1, [('prefix', 'prefix xterm -e')]),
        (
            {'env_changes': {'A': 'x', 'B': None}},
            -1,
            [('environment', "environment A = 'x'"), ('environment', 'environment B unset')],
        ),
        ({'cwd': '/a'}, -1, [('cwd', 'in the folder /a')]),
        ({'respawn': True}, -1, [('respawn', 'started again when it ends')]),
        ({'respawn': True, 'respawn_delay': 2.0}, 0, [('respawn', 'started again when it ends, 2 s later, at most 0 times')]),
        ({'output': 'screen'}, -1, [('output', 'output screen')]),
        ({'remappings': [('a', 'b')]}, -1, [('remap', 'remap a -> b')]),
        ({'other_ros_arguments': ['--log-level', 'debug']}, -1, [('arguments', 'ROS arguments --log-level debug')]),
    ],
)
def test_details_of_programs(change: dict[str, Any], limit: int, found: list[tuple[str, str]]) -> None:
    action = SimpleNamespace(respawn_limit=limit)
    assert details({**NODE, **change}, action=action) == found
    if 'remappings' not in change and 'other_ros_arguments' not in change:
        assert details({'kind': 'process', **PROCESS, **change}, action=action) == found


def test_details_of_other_actions() -> None:
    node = {'namespace': '/ns/', 'name': 'n', 'package': 'p', 'plugin': 'p::C', 'remappings': ['a:=b'], 'parameters': {'x': 1}}
    assert details(
        {'kind': 'load_composable_nodes', 'nodes': [node, {**node, 'name': None, 'remappings': [], 'parameters': {}}]}
    ) == [
        ('composable_node', 'composable node /ns/n: p p::C, remap a -> b'),
        ('parameter', 'with parameter x = 1'),
        ('composable_node', 'composable node /ns/(its own name): p p::C'),
    ]
    assert details({'kind': 'reset_configurations', 'kept': {'a': 'x'}}) == [('kept', "but a = 'x'")]
    assert details({'kind': 'event_handler'}) == [('never', 'never happened here')]
    assert details({'kind': 'event_handler'}, children=[1]) == []
    assert details({'kind': 'log'}) == []


@pytest.mark.parametrize(('length', 'shown'), [(98, "'" + 'x' * 98 + "'"), (99, "'" + 'x' * 79 + '...  [101 characters]')])
def test_a_long_value_is_cut(length: int, shown: str) -> None:
    assert shown_value('x' * length) == shown


@pytest.mark.parametrize(
    ('action', 'name', 'words'),
    [
        (GroupAction([]), 'GroupAction', 'group'),
        (OpaqueFunction(function=print), 'OpaqueFunction', 'function'),
        (SetEnvironmentVariable('A', 'x'), 'SetEnvironmentVariable', "SetEnvironmentVariable 'A'"),
        (LogInfo(msg=['a', LaunchConfiguration('x')]), 'LogInfo', "LogInfo 'a' LaunchConfig('x')"),
        (IncludeLaunchDescription('/a.launch.py'), 'IncludeLaunchDescription', "IncludeLaunchDescription '/a.launch.py'"),
        (
            IncludeLaunchDescription(PathJoinSubstitution([LaunchConfiguration('folder'), 'launch', 'world.launch.py'])),
            'IncludeLaunchDescription',
            "IncludeLaunchDescription 'world.launch.py'",
        ),
        (
            IncludeLaunchDescription([LaunchConfiguration('file')]),
            'IncludeLaunchDescription',
            "IncludeLaunchDescription LaunchConfig('file')",
        ),
        (SimpleNamespace(), 'SimpleNamespace', 'SimpleNamespace'),
    ],
)
def test_an_action_that_was_not_visited_is_named_by_what_is_known(action: Any, name: str, words: str) -> None:
    assert action_words(action) == (name, words)


def branch(action: str, **item: Any) -> Branch:
    made = Branch(type(action, (), {})())
    made.item = {'kind': '', **item} if item else None
    return made


def test_setters_follow_scopes() -> None:
    setters = Setters()
    first = branch('DeclareLaunchArgument', kind='argument', name='a')
    second = branch('SetLaunchConfiguration', kind='set_configuration', name='a')
    other = branch('SetLaunchConfiguration', kind='set_configuration', name='b')
    read = branch('Node', kind='node', name='a')
    for one in (first, branch('PushLaunchConfigurations'), second, other, read):
        setters.executed(one)
    assert (second.setters, read.setters) == ({'a': first}, {'a': second, 'b': other})
    assert setters.now == {'a': second, 'b': other}
    setters.executed(branch('UnsetLaunchConfiguration', kind='unset_configuration', name='a'))
    assert setters.now == {'b': other}
    setters.executed(branch('PopLaunchConfigurations'))
    assert setters.now == {'a': first}
    setters.executed(branch('PopLaunchConfigurations'))
    assert setters.now == {'a': first}
    setters.executed(other)
    setters.executed(branch('ResetLaunchConfigurations', kept={'b': '1'}))
    assert setters.now == {'b': other}


def test_a_branch_knows_who_is_above_it_and_asks_for_parameters_once() -> None:
    asked: list[int] = []
    action = SimpleNamespace(calls=[], given_parameters=lambda: asked.append(1) or ['p'])
    origin: Any = ('/a.py', 3)
    above, below = Branch(action, origin), Branch(None, condition='if 1')
    assert above.add(below) is below
    assert (above.children, below.parent_origin, below.condition, above.is_taken) == ([below], origin, 'if 1', False)
    assert (above.given_parameters, above.given_parameters, asked) == (['p'], ['p'], [1])
