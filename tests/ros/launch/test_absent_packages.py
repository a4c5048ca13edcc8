"""Launch files of robots that need what edulaunch does not have: the rest goes on, and one sentence says what is missing."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch import LaunchFileError, Session

START = """
import os
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, LogInfo
from launch.substitutions import Command, FindExecutable, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([
        {entity},
        LogInfo(msg='it goes on'),
    ])
"""


def run(folder: Path, entity: str) -> list[str]:
    """The lines of a launch with one entity before the last."""
    path = folder / 'robot.launch.py'
    path.write_text(START.format(entity=entity))
    with Session() as session:
        launch = session.launch(str(path))
        session.run(1)
        launch.raise_error()
        return [line for output in session.recording().output for line in output.text.rstrip('\n').split('\n')]


def test_a_program_of_an_absent_package_ends_and_the_rest_goes_on(tmp_path: Path) -> None:
    lines = run(tmp_path, "Node(package='ros_gz_bridge', executable='parameter_bridge')")
    assert '[INFO] [launch.user]: it goes on' in lines
    assert any(line.startswith('[ERROR] [parameter_bridge-1]: process has died [pid 1002, exit code 1,') for line in lines)


@pytest.mark.parametrize(
    'path',
    [
        "[get_package_share_directory('gazebo_ros'), '/launch/gazebo.launch.py']",
        "os.path.join(get_package_share_directory('gazebo_ros'), 'launch', 'gazebo.launch.py')",
        "PathJoinSubstitution([FindPackageShare('gazebo_ros'), 'launch', 'gazebo.launch.py'])",
    ],
)
def test_a_launch_file_of_an_absent_package_is_left_out(tmp_path: Path, path: str) -> None:
    told, last = run(tmp_path, f"IncludeLaunchDescription({path}, launch_arguments={{'world': 'w'}}.items())")[-2:]
    assert told == (
        "[ERROR] [launch]: gazebo_ros/launch/gazebo.launch.py is not included: the package 'gazebo_ros' (Gazebo) is not here; "
        'the rest of the launch continues without it'
    )
    assert last == '[INFO] [launch.user]: it goes on'


@pytest.mark.parametrize('command', ["['image_view ', 'a']", "[FindExecutable(name='image_view'), ' a']"])
def test_the_output_of_an_absent_program_is_empty(tmp_path: Path, command: str) -> None:
    assert run(tmp_path, f"LogInfo(msg=['<', Command({command}), '>'])")[-3:-1] == [
        "[ERROR] [launch]: the program 'image_view' (windows) is not here: the output of its command is empty",
        '[INFO] [launch.user]: <>',
    ]


def test_a_file_of_an_absent_package_that_is_opened_is_explained(tmp_path: Path) -> None:
    with pytest.raises(LaunchFileError) as caught:
        run(tmp_path, "LogInfo(msg=open(get_package_share_directory('nav2_bringup') + '/params/nav2_params.yaml').read())")
    assert str(caught.value.help).startswith('the package nav2_bringup (Navigation 2) is not part of edulaunch, so its files')


def test_a_package_that_nobody_knows_ends_the_launch_as_in_ros(tmp_path: Path) -> None:
    with pytest.raises(LaunchFileError, match="package 'my_robott' not found, searching: "):
        run(tmp_path, "Node(package='my_robott', executable='x')")
