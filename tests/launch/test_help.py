"""The line of help below each mistake that students make: golden texts."""

# ruff: noqa: E501
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from launch._help import help_line, launch_help, launch_origin
from launch.launch_description_sources import get_launch_description_from_any_launch_file

IMPORTS = (
    'from launch import LaunchDescription\nfrom launch.actions import *\nfrom launch.substitutions import *\n'
    'from launch.conditions import *\nfrom launch.event_handlers import *\n'
)

MISTAKES = {
    'from launch.actions import IfCondition': 'IfCondition lives in launch.conditions',
    'from launch.actions import DeclareLaunchArgumnt': "did you mean 'DeclareLaunchArgument'?",
    'from nav2_common.launch import RewrittenYaml': "the module 'nav2_common' (Navigation 2) is not here",
    'import qqq_zzz.parts': "if 'qqq_zzz' is a package of yours, go to its workspace or name that with --workspace DIR; if it is not, try: pip install qqq_zzz",
    'from launch.action_s import LogInfo': "did you mean 'from launch.actions import ...'?",
    'import launch\nx = launch.actions.LogInf': "did you mean 'LogInfo'?",
    'from .other import x': 'a launch file belongs to no package: put the shared code into your Python package, and write from my_package.module import ... without the leading dot',
    'x = RegisterEventHandlr': "did you mean 'RegisterEventHandler' (from launch.actions import RegisterEventHandler)?",
    'x = PythonLaunchDescriptionSource': 'add the line: from launch.launch_description_sources import '
    'PythonLaunchDescriptionSource',
    'x = os.getcwd()': 'add the line: import os',
    'x = true': 'Python writes True',
    "x = DeclareLaunchArgument('a', default_value=3)": "default_value=3 must be a text: write default_value='3'",
    "x = DeclareLaunchArgument('a', default_value=True)": "default_value=True must be a text: write default_value='true'",
    "x = DeclareLaunchArgument('a', default='3')": 'DeclareLaunchArgument has no default=; did you mean default_value=?',
    "x = ExecuteProcess(cmd=['ls'], outptu='screen')": 'ExecuteProcess has no outptu=; did you mean output=?',
    "from launch_ros.actions import Node\nx = Node(package='a', executable='b', parameters={'a': 1})": 'put it into a list: parameters=[...]',
    "from launch_ros.actions import Node\nx = Node(package='a', executable='b', node_name='c')": 'Node has no node_name=; did you mean name=?',
    "x = LogInfo('hello')": 'give the arguments by name: LogInfo(msg=...)',
    "x = LogInfo(msg=['a', 3])": "3 must be a text: write '3'",
    "import pathlib\nfrom launch_ros.actions import SetParametersFromFile\nx = SetParametersFromFile(filename=pathlib.Path('a.yaml'))": 'a path must be a text here: write filename=str(...)',
    "import pathlib\nx = LogInfo(msg=['in ', pathlib.Path('a')])": 'a path must be a text here: write str(...)',
    'x = TimerAction(period=2, actions=[])': 'write period=2.0',
    "x = SetLaunchConfiguration('a', valeu='1')": 'SetLaunchConfiguration needs value=...; did you mean that by valeu=?',
    'x = GroupAction(actons=[])': 'GroupAction needs actions=...; did you mean that by actons=?',
    "from launch_ros.actions import Node\nx = Node(package='a', executabel='b')": 'Node needs executable=...; did you mean that by executabel=?',
    "from launch_ros.actions import PushRosNamespace\nx = PushRosNamespace(namespce='a')": 'PushROSNamespace needs namespace=...; did you mean that by namespce=?',
    "from launch_ros.actions import SetRemap\nx = SetRemap('a')": 'SetRemap needs dst=...',
    "from launch_ros.actions import LifecycleNode\nx = LifecycleNode(package='a', executable='b', name='n')": 'LifecycleNode needs namespace=...',
    "x = TimerAction(period=2.0, actions=LogInfo(msg='a'))": 'put it into a list: actions=[...]',
    "x = LaunchDescription(LogInfo(msg='a'))": 'a list is expected: put the LogInfo into [ ]',
    "x = LogInfo(msg='a')(LogInfo(msg='b'))": 'perhaps a comma is missing after LogInfo(...)',
    'x = 1': 'a launch file needs: def generate_launch_description(): return LaunchDescription([...])',
}


@pytest.mark.filterwarnings('ignore::SyntaxWarning')
@pytest.mark.parametrize('line', MISTAKES)
def test_a_mistake_in_a_file_is_explained(line: str, tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text(IMPORTS + line + '\n')
    with pytest.raises(Exception) as caught:
        get_launch_description_from_any_launch_file(str(path))
    assert launch_help(caught.value) == MISTAKES[line]
    if line != 'x = 1':
        lines_before = IMPORTS.count('\n') + line.count('\n')
        assert launch_origin(caught.value) == (str(path), lines_before + 1)


def test_a_module_beside_the_launch_file_is_not_found(tmp_path: Path) -> None:
    (tmp_path / 'shared_nodes.py').touch()
    path = tmp_path / 'wrong.launch.py'
    path.write_text('import shared_nodes\n')
    with pytest.raises(Exception) as caught:
        get_launch_description_from_any_launch_file(str(path))
    assert launch_help(caught.value) == (
        "the launch file's own folder is not searched: move shared_nodes.py into your Python package"
    )


def test_syntax_errors_have_their_line(tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text('x = [\n1 2]\n')
    with pytest.raises(Exception) as caught:
        get_launch_description_from_any_launch_file(str(path))
    assert launch_origin(caught.value) == (str(path), 2)


VISITED = {
    "LogInfo(msg=LaunchConfiguration('robot_nam'))": "did you mean 'robot_name'?",
    "LogInfo(msg=LaunchConfiguration('zzz'))": "put DeclareLaunchArgument('zzz', default_value='...') before its use",
    "LogInfo(msg='a', condition=IfCondition('yes'))": 'conditions take true, 1, false or 0; compare texts with '
    'EqualsSubstitution(left, right)',
    "LogInfo(msg=PythonExpression(['abc', ' == \"abc\"']))": 'the text abc stands bare in a PythonExpression: put quotes '
    "around the substitution, as in [\"'\", LaunchConfiguration('x'), \"' == 'text'\"]",
    "IncludeLaunchDescription(__file__, launch_arguments={'name': '1', 'other': '2'})": 'launch_arguments needs (name, value) pairs: add .items() to the dictionary',
    "OpaqueFunction(function=lambda context: LogInfo(msg='a'))": 'a list is expected: put the LogInfo into [ ]',
    "LogInfo(msg='a', condition=LaunchConfiguration('x'))": 'a condition is expected: put IfCondition(...) or UnlessCondition(...) around the LaunchConfiguration',
    "ExecuteProcess(cmd=['ls'], on_exit='shutdown')": 'what is to happen then is an action, or a list of actions, such as Shutdown()',
    "'text'": 'among the entities is a str: a list of actions holds only actions and launch descriptions',
}


@pytest.mark.parametrize('entity', VISITED)
def test_a_mistake_found_while_launching_is_explained_with_its_line(entity: str, launch_it: Any, tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text(
        f'{IMPORTS}def generate_launch_description():\n    return LaunchDescription([\n'
        f"        SetLaunchConfiguration('robot_name', 'r2'),\n        {entity}])\n"
    )
    from launch.actions import IncludeLaunchDescription

    code, lines = launch_it(IncludeLaunchDescription(str(path)))
    assert code == 1
    assert lines[-1].startswith('  help: ')
    assert lines[-1].endswith(VISITED[entity])
    if entity != "'text'":
        assert f'{path}:9 ({entity.partition("(")[0]})' in lines[-1]


def test_an_argument_of_a_group_that_is_over_is_explained(launch_it: Any, tmp_path: Path) -> None:
    from launch.actions import GroupAction, LogInfo
    from launch.substitutions import LaunchConfiguration

    path = tmp_path / 'part.launch.py'
    path.write_text(
        f'{IMPORTS}def generate_launch_description():\n'
        "    return LaunchDescription([DeclareLaunchArgument('robot', default_value='r2')])\n"
    )
    from launch.actions import IncludeLaunchDescription

    lines = launch_it(GroupAction([IncludeLaunchDescription(str(path))]), LogInfo(msg=LaunchConfiguration('robot')))[1]
    assert "'robot' was set inside a GroupAction that is over by now" in lines[-1]


def test_a_namespace_that_cannot_be_one_is_explained(launch_it: Any) -> None:
    from launch_ros.actions import PushROSNamespace

    lines = launch_it(PushROSNamespace('a-b'))[1]
    assert lines[-1].endswith(": a namespace has letters, digits, '_' and '/' only, and no part of it begins with a digit")


def test_an_error_nobody_knows_has_no_line() -> None:
    assert help_line(ValueError('something')) is None


def test_a_session_can_show_the_help_itself(launch_it: Any, fresh_simulation: Any) -> None:
    from launch.actions import LogInfo
    from launch.substitutions import LaunchConfiguration

    shown: list[BaseException] = []
    fresh_simulation.state['launch.show_help'] = shown.append
    lines = launch_it(LogInfo(msg=LaunchConfiguration('x')))[1]
    assert len(lines) == len(shown) == 1
