"""The line of help below each mistake that students make in Python launch files: golden texts."""

# ruff: noqa: E501
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from launch._failure import failure_data, launch_origin
from launch.launch_description_sources import get_launch_description_from_any_launch_file

import edulaunch
from edulaunch.advice.rendering import help_of

IMPORTS = (
    'from launch import LaunchDescription\nfrom launch.actions import *\nfrom launch.substitutions import *\n'
    'from launch.conditions import *\nfrom launch.event_handlers import *\n'
)

MISTAKES = {
    'from launch.actions import IfCondition': 'launch.actions does not contain IfCondition; write: from launch.conditions import IfCondition',
    'from launch.actions import DeclareLaunchArgumnt': 'launch.actions does not contain DeclareLaunchArgumnt; write: from launch.actions import DeclareLaunchArgument',
    'from nav2_common.launch import RewrittenYaml': 'the module nav2_common (Navigation 2) is not part of edulaunch; run this launch file on a computer where nav2_common is installed',
    'import qqq_zzz.parts': 'the module qqq_zzz does not exist; change to the workspace that contains this module, or name it with --workspace DIR',
    'from launch.action_s import LogInfo': 'the module launch.action_s does not exist; write: from launch.actions import ...',
    'import launch\nx = launch.actions.LogInf': 'launch.actions does not contain LogInf; write: from launch.actions import LogInfo',
    'from .other import x': 'a launch file is not part of a package, so Python cannot resolve an import with a leading dot; put the shared code into your Python package, and write: from my_package.module import ...',
    'x = RegisterEventHandlr': 'the name RegisterEventHandlr is not defined; write RegisterEventHandler, and add this line: from launch.actions import RegisterEventHandler',
    'x = PythonLaunchDescriptionSource': 'the name PythonLaunchDescriptionSource is not defined; add this line: from launch.launch_description_sources import PythonLaunchDescriptionSource',
    'x = os.getcwd()': 'the name os is not defined; add this line: import os',
    'x = true': 'the name true is not defined; write True',
    '  x = 1': 'line 6 is indented further than the line above, which does not begin a block; indent line 6 like the line above, or add the line that begins the block, such as def or if',
    "x = DeclareLaunchArgument('a', default_value=3)": "default_value=3 is of type int, but launch expects strings and substitutions here; write default_value='3'",
    "x = DeclareLaunchArgument('a', default_value=True)": "default_value=True is of type bool, but launch expects strings and substitutions here; write default_value='true'",
    "x = DeclareLaunchArgument('a', default='3')": 'DeclareLaunchArgument has no argument default=; write default_value=',
    "x = ExecuteProcess(cmd=['ls'], outptu='screen')": 'ExecuteProcess has no argument outptu=; write output=',
    "from launch_ros.actions import Node\nx = Node(package='a', executable='b', parameters={'a': 1})": 'the value of parameters= cannot be of type dict; put the value into a list: parameters=[...]',
    "from launch_ros.actions import Node\nx = Node(package='a', executable='b', node_name='c')": 'Node has no argument node_name=; write name=',
    "from launch.launch_description_sources import PythonLaunchDescriptionSource\nx = IncludeLaunchDescription(PythonLaunchDescriptionSource('a.launch.py', launch_arguments=[]))": 'PythonLaunchDescriptionSource has no argument launch_arguments=; use one of these arguments: launch_file_path=',
    "x = LogInfo('hello')": 'LogInfo does not accept these arguments without names; write the name of the argument: LogInfo(msg=...)',
    "x = LogInfo(msg=['a', 3])": "launch expects a string here, and this value is of type int; write '3'",
    "import pathlib\nfrom launch_ros.actions import SetParametersFromFile\nx = SetParametersFromFile(filename=pathlib.Path('a.yaml'))": 'launch expects a string here, and this value is of type PosixPath; write filename=str(...) to convert the path to a string',
    "import pathlib\nx = LogInfo(msg=['in ', pathlib.Path('a')])": 'launch expects a string here, and this value is of type PosixPath; write str(...) to convert the path to a string',
    'x = TimerAction(period=2, actions=[])': 'the value of period= cannot be of type int; write the number with a decimal point: period=2.0',
    "x = SetLaunchConfiguration('a', valeu='1')": 'SetLaunchConfiguration needs the argument value=; replace valeu= with value=',
    'x = GroupAction(actons=[])': 'GroupAction needs the argument actions=; replace actons= with actions=',
    "from launch_ros.actions import Node\nx = Node(package='a', executabel='b')": 'Node needs the argument executable=; replace executabel= with executable=',
    "from launch_ros.actions import PushRosNamespace\nx = PushRosNamespace(namespce='a')": 'PushROSNamespace needs the argument namespace=; replace namespce= with namespace=',
    "from launch_ros.actions import SetRemap\nx = SetRemap('a')": 'SetRemap needs the argument dst=; add dst=...',
    "from launch_ros.actions import LifecycleNode\nx = LifecycleNode(package='a', executable='b', name='n')": 'LifecycleNode needs the argument namespace=; add namespace=...',
    "x = TimerAction(period=2.0, actions=LogInfo(msg='a'))": 'the value of actions= cannot be of type launch.actions.log_info.LogInfo; put the value into a list: actions=[...]',
    "x = LaunchDescription(LogInfo(msg='a'))": 'launch expects a list here, not a single LogInfo; put it into square brackets: [LogInfo(...)]',
    "x = LogInfo(msg='a')(LogInfo(msg='b'))": 'a comma is missing after LogInfo(...), so Python reads the next brackets as a part of it; put a comma after LogInfo(...)',
    'x = 1': 'this launch file has no function generate_launch_description(); write `def generate_launch_description(): return LaunchDescription([...])`',
}


def error_of(path: Path) -> Exception:
    with pytest.raises(Exception) as caught:
        get_launch_description_from_any_launch_file(str(path))
    return caught.value


@pytest.mark.filterwarnings('ignore::SyntaxWarning')
@pytest.mark.parametrize('line', MISTAKES)
def test_a_mistake_in_a_file_is_explained(line: str, tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text(IMPORTS + line + '\n')
    error = error_of(path)
    assert help_of(failure_data(error)) == MISTAKES[line]
    if line != 'x = 1':
        lines_before = IMPORTS.count('\n') + line.count('\n')
        assert launch_origin(error) == (str(path), lines_before + 1)


def test_a_module_beside_the_launch_file_is_not_found(tmp_path: Path) -> None:
    (tmp_path / 'shared_nodes.py').touch()
    path = tmp_path / 'wrong.launch.py'
    path.write_text('import shared_nodes\n')
    assert str(help_of(failure_data(error_of(path)))).startswith('shared_nodes.py is next to the launch file, but')


def test_syntax_errors_have_their_line(tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text('x = [\n1 2]\n')
    assert launch_origin(error_of(path)) == (str(path), 2)


VISITED = {
    "LogInfo(msg=LaunchConfiguration('robot_nam'))": "  help: @:9 (LogInfo): the launch configuration 'robot_nam' does not exist; write 'robot_name' if you mean this name",
    "LogInfo(msg=LaunchConfiguration('zzz'))": "  help: @:9 (LogInfo): the launch configuration 'zzz' does not exist; write DeclareLaunchArgument('zzz', default_value='...') before this use",
    "LogInfo(msg='a', condition=IfCondition('yes'))": '  help: @:9 (LogInfo): this condition is neither true nor false; use true, 1, false or 0, and compare strings with EqualsSubstitution(left, right)',
    "LogInfo(msg=PythonExpression(['abc', ' == \"abc\"']))": "  help: @:9 (LogInfo): the string abc has no quotes in a PythonExpression, so Python reads it as a name; put quotes around the substitution, as in [\"'\", LaunchConfiguration('x'), \"' == 'abc'\"]",
    "IncludeLaunchDescription(__file__, launch_arguments={'name': '1', 'other': '2'})": "  help: @:9 (IncludeLaunchDescription): launch_arguments needs (name, value) pairs, and this value has a different form; write {'name': 'value'}.items()",
    "OpaqueFunction(function=lambda context: LogInfo(msg='a'))": '  help: @:9 (OpaqueFunction): launch expects a list here, not a single LogInfo; put it into square brackets: [LogInfo(...)]',
    "LogInfo(msg='a', condition=LaunchConfiguration('x'))": '  help: @:9 (LogInfo): condition= needs a condition, and its value is a LaunchConfiguration; write IfCondition(...) or UnlessCondition(...) around the value',
    "ExecuteProcess(cmd=['ls'], on_exit='shutdown')": '  help: @:9 (ExecuteProcess): this event handler received something that is not an action; pass an action or a list of actions, such as on_exit=[Shutdown()]',
    "'text'": '  help: the list of actions contains a str; list only actions and launch descriptions: Node(...), LogInfo(...), IncludeLaunchDescription(...)',
}


def said(path: Path, **options: Any) -> list[str]:
    """What stands on the console of a launch."""
    written: list[str] = []
    with edulaunch.Session(console=lambda stream, text: written.append(text)) as session:
        session.launch(path)
        session.run(1.0)
        recorded = ''.join(line.text for line in session.recording().output)
    assert 'help: ' not in recorded
    return ''.join(written).splitlines()


@pytest.mark.parametrize('entity', VISITED)
def test_a_mistake_found_while_launching_is_explained_with_its_line(entity: str, tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text(
        f'{IMPORTS}def generate_launch_description():\n    return LaunchDescription([\n'
        f"        SetLaunchConfiguration('robot_name', 'r2'),\n        {entity}])\n"
    )
    assert VISITED[entity].replace('@', str(path)) in said(path)


def test_an_argument_of_a_group_that_is_over_is_explained(tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    (tmp_path / 'part.launch.py').write_text(
        f'{IMPORTS}def generate_launch_description():\n'
        "    return LaunchDescription([DeclareLaunchArgument('robot', default_value='r2')])\n"
    )
    path.write_text(
        f'{IMPORTS}def generate_launch_description():\n    part = __file__.replace("wrong", "part")\n'
        "    return LaunchDescription([GroupAction([IncludeLaunchDescription(part)]), LogInfo(msg=LaunchConfiguration('robot'))])\n"
    )
    assert "'robot' was set inside a GroupAction that has already ended; add scoped=False to the group" in said(path)[-1]


def test_of_an_error_that_nobody_knows_the_place_is_told(tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text("def generate_launch_description():\n    raise ValueError('odd')\n")
    assert said(path)[-1] == f'  help: {path}:2 (IncludeLaunchDescription)'
    assert help_of({'type': 'ValueError', 'message': 'something', 'place': None, 'facts': {}}) is None
