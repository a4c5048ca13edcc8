"""Terminals of one machine have folders of their own: a relative path begins in that of its `ros2 launch`."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.engine.processes import ProcessSpec
from edulaunch.runtime.session import Session

FILES = {
    'note.txt': 'a note',
    'red.yaml': '/**:\n  ros__parameters:\n    background_r: 11\n',
    'green.yaml': '/**:\n  ros__parameters:\n    background_g: $(var green)\n',
    'sim_time.yaml': '/**:\n  ros__parameters:\n    use_sim_time: true\n',
    'inner.launch.py': """
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import ThisLaunchFileDir

def generate_launch_description():
    return LaunchDescription([LogInfo(msg=['inner in ', ThisLaunchFileDir()])])
""",
    'inner.launch.xml': '<launch><log message="inner xml in $(dirname)"/></launch>',
    'deep/outer.py': """
import pathlib, subprocess, sys
print('outer reads', pathlib.Path('beside.txt').read_text())
subprocess.run([sys.executable, 'inner.py'], cwd='deeper')
""",
    'deep/beside.txt': 'beside',
    'deep/deeper/inner.py': "import os\nprint('inner is in', os.path.basename(os.getcwd()))",
    'all.launch.py': """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription, LogInfo
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, FileContent
from launch_ros.actions import ComposableNodeContainer, Node, SetParametersFromFile
from launch_ros.descriptions import ComposableNode, ParameterFile

def sim(name, parameters=None):
    return Node(package='turtlesim', executable='turtlesim_node', name=name, parameters=parameters)

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('green', default_value='22'),
        LogInfo(msg=['file: ', FileContent('note.txt')]),
        LogInfo(msg=['command: ', Command('cat note.txt')]),
        IncludeLaunchDescription(PythonLaunchDescriptionSource('inner.launch.py')),
        IncludeLaunchDescription('inner.launch.xml'),
        ExecuteProcess(cmd=['cat', 'note.txt'], name='cat', output='screen'),
        ExecuteProcess(cmd=['python3', 'outer.py'], cwd='deep', name='outer', output='screen'),
        sim('one', ['red.yaml', ParameterFile('green.yaml', allow_substs=True)]),
        SetParametersFromFile('red.yaml'),
        sim('two'),
        ComposableNodeContainer(
            package='rclcpp_components', executable='component_container', name='container', namespace='',
            composable_node_descriptions=[
                ComposableNode(package='composition', plugin='composition::Talker', name='three', parameters=['sim_time.yaml']),
            ],
        ),
    ])
""",
}


@pytest.mark.processes
def test_relative_paths_begin_in_the_folder_of_the_terminal(tmp_path: Path) -> None:
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    printed: list[str] = []
    with Session() as session:
        spec = ProcessSpec(argv=('ros2', 'launch', 'all.launch.py'), name='ros2', cwd=str(tmp_path))
        session.host.start(spec, lambda stream, text: printed.append(text))
        session.run(5)
        recording = session.snapshot()
    lines = [line for line in ''.join(printed).splitlines() if '[launch.user]' in line or line.startswith(('[cat', '[outer'))]
    assert lines == [
        '[INFO] [launch.user]: file: a note',
        '[INFO] [launch.user]: command: a note',
        f'[INFO] [launch.user]: inner in {tmp_path}',
        f'[INFO] [launch.user]: inner xml in {tmp_path}',
        '[outer-2] outer reads beside',
        '[outer-2] inner is in deeper',
        '[cat-1] a note',
    ]
    assert [recording.parameters('/one')[name].value for name in ('background_r', 'background_g')] == [11, 22]
    assert recording.parameters('/two')['background_r'].value == 11
    assert recording.parameters('/three')['use_sim_time'].value is True
