"""Including files: arguments, scope, locals, required arguments, and how often files are loaded."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from launch import LaunchContext, LaunchDescription, LaunchDescriptionSource
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, LogInfo, TimerAction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, ThisLaunchFileDir

HEAD = ''.join(f'from launch{name} import *\n' for name in ('', '.actions', '.conditions', '.substitutions'))


@pytest.fixture
def write(tmp_path: Path) -> Any:
    """Writes a launch file with the given list of entities; gives its path."""

    def write_file(name: str, entities: str, before: str = '') -> str:
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(f'{HEAD}{before}def generate_launch_description():\n    return LaunchDescription([{entities}])\n')
        return str(path)

    return write_file


def said(lines: list[str]) -> list[str]:
    return [line.partition(']: ')[2] for line in lines if line.startswith('[INFO] [launch.user]')]


def test_arguments_are_set_before_and_leak_afterwards(launch_it: Any, write: Any) -> None:
    path = write('a.launch.py', "LogInfo(msg=['in ', LaunchConfiguration('x')]), SetLaunchConfiguration('y', '2')")
    lines = launch_it(
        IncludeLaunchDescription(path, launch_arguments={'x': '1'}.items()),
        LogInfo(msg=['out ', LaunchConfiguration('x'), LaunchConfiguration('y')]),
    )[1]
    assert said(lines) == ['in 1', 'out 12']


def test_a_group_keeps_arguments_inside_but_not_the_current_folder(launch_it: Any, write: Any, tmp_path: Path) -> None:
    path = write('sub/a.launch.py', '')
    lines = launch_it(
        GroupAction([IncludeLaunchDescription(path, launch_arguments=[('x', '1')])]),
        LogInfo(msg=[LaunchConfiguration('x', default='gone'), ' ', ThisLaunchFileDir()]),
    )[1]
    assert said(lines) == [f'gone {tmp_path}/sub']


def test_a_missing_required_argument_names_what_was_given(launch_it: Any, write: Any) -> None:
    path = write('a.launch.py', "DeclareLaunchArgument('needed', description='must')")
    code, lines = launch_it(IncludeLaunchDescription(path, launch_arguments=[('a', '1'), ('b', '2')]))
    assert code == 1
    assert lines[0].endswith(
        "Included launch description missing required argument 'needed' (description: 'must'), given: [a, b]"
    )


def test_configurations_that_are_set_do_not_replace_arguments(launch_it: Any, write: Any) -> None:
    from launch.actions import SetLaunchConfiguration

    path = write('a.launch.py', "DeclareLaunchArgument('needed')")
    assert launch_it(SetLaunchConfiguration('needed', '1'), IncludeLaunchDescription(path))[0] == 1


def test_arguments_of_nested_includes_count_as_given(launch_it: Any, write: Any) -> None:
    inner = write('inner.launch.py', "DeclareLaunchArgument('needed')")
    outer = write('outer.launch.py', f"IncludeLaunchDescription({inner!r}, launch_arguments=[('needed', '1')])")
    assert launch_it(IncludeLaunchDescription(outer)) == (0, [])


def test_arguments_of_a_file_that_is_included_under_a_condition_are_required(launch_it: Any, write: Any) -> None:
    path = write('a.launch.py', "DeclareLaunchArgument('needed')")
    include = IncludeLaunchDescription(path, condition=IfCondition('false'))
    arguments = LaunchDescription([include]).get_launch_arguments()
    assert [(argument.name, argument._conditionally_included) for argument in arguments] == [('needed', False)]
    outer = write('outer.launch.py', f"IncludeLaunchDescription({path!r}, condition=IfCondition('false'))")
    code, lines = launch_it(IncludeLaunchDescription(outer))
    assert (code, 'missing required argument' in lines[0]) == (1, True)


def test_arguments_that_stand_in_a_conditional_branch_are_not_required(launch_it: Any, write: Any) -> None:
    group = GroupAction([DeclareLaunchArgument('a')], condition=IfCondition('false'))
    timer = TimerAction(period=1.0, actions=[DeclareLaunchArgument('b')])
    own = DeclareLaunchArgument('c', condition=IfCondition('false'))
    arguments = LaunchDescription([group, timer, own, DeclareLaunchArgument('d')]).get_launch_arguments()
    assert [(one.name, one._conditionally_included) for one in arguments] == [('a', True), ('b', True), ('c', True), ('d', False)]
    path = write('b.launch.py', "GroupAction([DeclareLaunchArgument('a')], condition=IfCondition('false'))")
    assert launch_it(IncludeLaunchDescription(path)) == (0, [])


def test_a_description_from_a_script_has_its_location_as_its_folder() -> None:
    context = LaunchContext()
    IncludeLaunchDescription(LaunchDescriptionSource(LaunchDescription(), '<script>')).visit(context)
    assert context.locals.current_launch_file_directory == '<script>'


def test_a_source_says_where_it_loads_from_and_fails_without_a_way() -> None:
    source = LaunchDescriptionSource(None, LaunchConfiguration('p'))
    assert 'launch.substitutions.launch_configuration.LaunchConfiguration' in source.location
    context = LaunchContext()
    context.launch_configurations['p'] = 'here'
    with pytest.raises(RuntimeError, match="no way to load one from 'here'"):
        source.get_launch_description(context)
    assert source.location == 'here'


def test_the_first_declaration_of_a_name_wins_and_a_reset_hides_the_rest(write: Any) -> None:
    path = write(
        'a.launch.py',
        "DeclareLaunchArgument('x', default_value='1'), ResetLaunchConfigurations(), DeclareLaunchArgument('hidden')",
    )
    description = LaunchDescription([IncludeLaunchDescription(path), DeclareLaunchArgument('x'), DeclareLaunchArgument('y')])
    found = description.get_launch_arguments_with_include_launch_description_actions()
    assert [(argument.name, includes and len(includes)) for argument, includes in found] == [('x', 1), ('y', None)]


def test_paths_that_depend_on_configurations_are_passed_over() -> None:
    assert LaunchDescription([IncludeLaunchDescription(LaunchConfiguration('p'))]).get_launch_arguments() == []


def test_a_chain_of_includes_loads_each_file_at_most_twice(launch_it: Any, write: Any, tmp_path: Path) -> None:
    log = tmp_path / 'log'
    depth = 12
    for n in range(depth):
        below = f'IncludeLaunchDescription({str(tmp_path)!r} + "/{n + 1}.launch.py")' if n + 1 < depth else ''
        write(f'{n}.launch.py', below, f'with open({str(log)!r}, "a") as log:\n    log.write("{n}\\n")\n')
    launch_it(IncludeLaunchDescription(f'{tmp_path}/0.launch.py'))
    loads = log.read_text().split()
    assert [loads.count(str(n)) for n in range(depth)] == [1] + [2] * (depth - 1)


def test_a_file_that_changed_is_searched_again(write: Any) -> None:
    include = IncludeLaunchDescription(write('a.launch.py', "DeclareLaunchArgument('x')"))
    assert [a.name for a in LaunchDescription([include]).get_launch_arguments()] == ['x']
    write('a.launch.py', "DeclareLaunchArgument('other')")
    assert [a.name for a in LaunchDescription([include]).get_launch_arguments()] == ['other']


def test_a_file_without_a_description_is_reported_as_in_ros(launch_it: Any, write: Any, tmp_path: Path) -> None:
    (tmp_path / 'none.launch.py').write_text('def generate_launch_description():\n    pass\n')
    code, lines = launch_it(IncludeLaunchDescription(f'{tmp_path}/none.launch.py'))
    assert "'NoneType' object has no attribute 'get_launch_arguments_with_include_launch_description_actions'" in lines[0]
    assert lines[1].endswith(
        'generate_launch_description() returned nothing, not a LaunchDescription; end the function with: return LaunchDescription([...])'
    )


def test_a_deprecated_file_warns_with_its_path(launch_it: Any, tmp_path: Path) -> None:
    path = tmp_path / 'old.launch.py'
    path.write_text(HEAD + "def generate_launch_description():\n    return LaunchDescription(deprecated_reason='use new')\n")
    assert launch_it(IncludeLaunchDescription(str(path)))[1] == [f'[WARNING] [root]: launch file [{path}] is deprecated: use new']


def test_what_was_declared_included_and_read_is_noted(launch_it: Any, write: Any, fresh_simulation: Any) -> None:
    path = write('a.launch.py', "DeclareLaunchArgument('x', default_value=LaunchConfiguration('y', default='z'))")
    launch_it(IncludeLaunchDescription(path))
    state = fresh_simulation.state
    assert [argument.name for argument in state['launch.declared']] == ['x']
    assert (state['launch.includes'], 'y' in state['launch.read']) == ([path], True)


def test_a_file_whose_function_returns_no_description_is_named_with_the_function(write: Any, tmp_path: Path) -> None:
    (tmp_path / 'a.launch.py').write_text('\ndef generate_launch_description():\n    return []\n')
    with pytest.raises(AttributeError) as caught:
        IncludeLaunchDescription(str(tmp_path / 'a.launch.py')).execute(LaunchContext())
    assert (caught.value.edulaunch_file, caught.value.edulaunch_line) == (str(tmp_path / 'a.launch.py'), 2)


def test_an_argument_that_the_file_does_not_declare_is_noted_with_those_that_it_does(write: Any, fresh_simulation: Any) -> None:
    path = write('a.launch.py', "DeclareLaunchArgument('x', default_value='1')")
    include = IncludeLaunchDescription(path, launch_arguments={'x': '2', 'y': '3'}.items())
    include.execute(LaunchContext())
    assert fresh_simulation.state['launch.undeclared'] == [('y', ['x'], path, include.origin)]
    assert fresh_simulation.state['launch.includes'] == [path]
