"""The line of help below each mistake that students make in Python launch files: golden texts."""

# ruff: noqa: E501
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from launch._failure import failure_data, launch_origin
from launch.launch_description_sources import get_launch_description_from_any_launch_file

import edulaunch
from edulaunch.advice.wording import help_of

IMPORTS = (
    'from launch import LaunchDescription\nfrom launch.actions import *\nfrom launch.substitutions import *\n'
    'from launch.conditions import *\nfrom launch.event_handlers import *\n'
)

MISTAKES = {
    'from launch.actions import IfCondition': 'launch.actions has no IfCondition; write: from launch.conditions import IfCondition',
    'from launch.actions import DeclareLaunchArgumnt': 'launch.actions has no DeclareLaunchArgumnt; write: from launch.actions import DeclareLaunchArgument',
    'from nav2_common.launch import RewrittenYaml': 'the module nav2_common (Navigation 2) is not part of edulaunch; try this launch file on a machine that has nav2_common',
    'import qqq_zzz.parts': 'there is no module qqq_zzz; go to the workspace with this module, or name that with --workspace DIR',
    'from launch.action_s import LogInfo': 'there is no module launch.action_s; write: from launch.actions import ...',
    'import launch\nx = launch.actions.LogInf': 'launch.actions has no LogInf; write: from launch.actions import LogInfo',
    'from .other import x': 'a launch file belongs to no package, so an import with a leading dot finds nothing; put the shared code into your Python package, and write: from my_package.module import ...',
    'x = RegisterEventHandlr': 'the name RegisterEventHandlr is not known here; write RegisterEventHandler, and add the line: from launch.actions import RegisterEventHandler',
    'x = PythonLaunchDescriptionSource': 'the name PythonLaunchDescriptionSource is not known here; add the line: from launch.launch_description_sources import PythonLaunchDescriptionSource',
    'x = os.getcwd()': 'the name os is not known here; add the line: import os',
    'x = true': 'the name true is not known here; write True',
    "x = DeclareLaunchArgument('a', default_value=3)": "default_value=3 is of type int, and texts and substitutions are expected; write default_value='3'",
    "x = DeclareLaunchArgument('a', default_value=True)": "default_value=True is of type bool, and texts and substitutions are expected; write default_value='true'",
    "x = DeclareLaunchArgument('a', default='3')": 'DeclareLaunchArgument has no argument default=; write default_value=',
    "x = ExecuteProcess(cmd=['ls'], outptu='screen')": 'ExecuteProcess has no argument outptu=; write output=',
    "from launch_ros.actions import Node\nx = Node(package='a', executable='b', parameters={'a': 1})": 'parameters= cannot be of type dict; put it into a list: parameters=[...]',
    "from launch_ros.actions import Node\nx = Node(package='a', executable='b', node_name='c')": 'Node has no argument node_name=; write name=',
    "from launch.launch_description_sources import PythonLaunchDescriptionSource\nx = IncludeLaunchDescription(PythonLaunchDescriptionSource('a.launch.py', launch_arguments=[]))": 'PythonLaunchDescriptionSource has no argument launch_arguments=; choose one of these: launch_file_path=',
    "x = LogInfo('hello')": 'LogInfo got its arguments without names; write the name: LogInfo(msg=...)',
    "x = LogInfo(msg=['a', 3])": "a value of type int stands where a text is expected; write '3'",
    "import pathlib\nfrom launch_ros.actions import SetParametersFromFile\nx = SetParametersFromFile(filename=pathlib.Path('a.yaml'))": 'a value of type PosixPath stands where a text is expected; write filename=str(...), so that the path becomes a text',
    "import pathlib\nx = LogInfo(msg=['in ', pathlib.Path('a')])": 'a value of type PosixPath stands where a text is expected; write str(...), so that the path becomes a text',
    'x = TimerAction(period=2, actions=[])': 'period= cannot be of type int; write it with its point: period=2.0',
    "x = SetLaunchConfiguration('a', valeu='1')": 'SetLaunchConfiguration needs value=; write value= where you wrote valeu=',
    'x = GroupAction(actons=[])': 'GroupAction needs actions=; write actions= where you wrote actons=',
    "from launch_ros.actions import Node\nx = Node(package='a', executabel='b')": 'Node needs executable=; write executable= where you wrote executabel=',
    "from launch_ros.actions import PushRosNamespace\nx = PushRosNamespace(namespce='a')": 'PushROSNamespace needs namespace=; write namespace= where you wrote namespce=',
    "from launch_ros.actions import SetRemap\nx = SetRemap('a')": 'SetRemap needs dst=; add dst=...',
    "from launch_ros.actions import LifecycleNode\nx = LifecycleNode(package='a', executable='b', name='n')": 'LifecycleNode needs namespace=; add namespace=...',
    "x = TimerAction(period=2.0, actions=LogInfo(msg='a'))": 'actions= cannot be of type launch.actions.log_info.LogInfo; put it into a list: actions=[...]',
    "x = LaunchDescription(LogInfo(msg='a'))": 'a list is expected where a LogInfo stands; put it into square brackets: [LogInfo(...)]',
    "x = LogInfo(msg='a')(LogInfo(msg='b'))": 'Python takes LogInfo(...) and the brackets behind it for one call; put a comma behind LogInfo(...)',
    'x = 1': 'this launch file has no function generate_launch_description(); write: def generate_launch_description(): return LaunchDescription([...])',
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
    assert str(help_of(failure_data(error_of(path)))).startswith('shared_nodes.py lies beside the launch file, and')


def test_syntax_errors_have_their_line(tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text('x = [\n1 2]\n')
    assert launch_origin(error_of(path)) == (str(path), 2)


VISITED = {
    "LogInfo(msg=LaunchConfiguration('robot_nam'))": "  help: @:9 (LogInfo): there is no launch configuration 'robot_nam'; write 'robot_name', if that is the one you mean",
    "LogInfo(msg=LaunchConfiguration('zzz'))": "  help: @:9 (LogInfo): there is no launch configuration 'zzz'; put DeclareLaunchArgument('zzz', default_value='...') before its use",
    "LogInfo(msg='a', condition=IfCondition('yes'))": '  help: @:9 (LogInfo): this condition is neither true nor false; give it true, 1, false or 0; compare texts with EqualsSubstitution(left, right)',
    "LogInfo(msg=PythonExpression(['abc', ' == \"abc\"']))": "  help: @:9 (LogInfo): the text abc stands bare in a PythonExpression, so Python takes it for a name; put quotes around the substitution, as in [\"'\", LaunchConfiguration('x'), \"' == 'abc'\"]",
    "IncludeLaunchDescription(__file__, launch_arguments={'name': '1', 'other': '2'})": "  help: @:9 (IncludeLaunchDescription): launch_arguments takes (name, value) pairs, and got something else; write {'name': 'value'}.items()",
    "OpaqueFunction(function=lambda context: LogInfo(msg='a'))": '  help: @:9 (OpaqueFunction): a list is expected where a LogInfo stands; put it into square brackets: [LogInfo(...)]',
    "LogInfo(msg='a', condition=LaunchConfiguration('x'))": '  help: @:9 (LogInfo): condition= is a LaunchConfiguration, and a condition is expected; put IfCondition(...) or UnlessCondition(...) around it',
    "ExecuteProcess(cmd=['ls'], on_exit='shutdown')": '  help: @:9 (ExecuteProcess): what an event handler is to do is no action; give it an action or a list of actions, such as on_exit=[Shutdown()]',
    "'text'": '  help: among the actions stands a str; give only actions and launch descriptions: Node(...), LogInfo(...), IncludeLaunchDescription(...)',
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
    assert "'robot' was set inside a GroupAction that is over by now; give the group scoped=False" in said(path)[-1]


def test_of_an_error_that_nobody_knows_the_place_is_told(tmp_path: Path) -> None:
    path = tmp_path / 'wrong.launch.py'
    path.write_text("def generate_launch_description():\n    raise ValueError('odd')\n")
    assert said(path)[-1] == f'  help: {path}:2 (IncludeLaunchDescription)'
    assert help_of({'type': 'ValueError', 'message': 'something', 'place': None, 'facts': {}}) is None
