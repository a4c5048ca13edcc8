"""What is said to commands that set up a real ROS 2 machine."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.advice.workspace.not_needed import answer


@pytest.mark.parametrize(
    ('line', 'part'),
    [
        ('colcon build --symlink-install', 'there is no package in this folder'),
        ('colcon test', 'python3 -m pytest'),
        ('colcon list', 'colcon list: not needed here'),
        ('rosdep install -i --from-path src --rosdistro jazzy -y', 'you do not need to install anything'),
        ('sudo rosdep init', 'you do not need to install anything'),
        ('sudo apt install ros-jazzy-turtlesim', 'apt: turtlesim is already part of edulaunch'),
        (
            'sudo apt-get install ros-humble-turtlesim ros-humble-demo-nodes-py',
            'turtlesim, demo_nodes_py are already part of edulaunch',
        ),
        ('apt install ros-jazzy-gazebo-ros', 'gazebo_ros is not part of edulaunch'),
        ('sudo apt install ~nros-jazzy-turtlesim*', 'apt: turtlesim is already part of edulaunch'),
        ('apt install ~nros-jazzy-rqt*', 'apt: rqt is already part of edulaunch'),
        ('gz sim world.sdf', 'gz is not part of edulaunch. Launch files for Gazebo'),
        ('gazebo', '`edulaunch view` shows it'),
        ('check_urdf robot.urdf', 'To check a URDF file, run'),
        ('source /opt/ros/jazzy/setup.bash', 'you do not need to source ROS 2 Jazzy'),
        ('rqt_graph', '`edulaunch view --tab graph`'),
        ('rviz2 -d turtle.rviz', '`edulaunch view --tab frames`'),
        ('ls install', 'there is no folder `install`, because edulaunch needs no build'),
        ('ls -l build/robo', 'there is no folder `build`'),
        ('ls /home/student/.ros/log', 'The folder appears at the first launch'),
        ('. install/local_setup.sh', 'edulaunch finds packages in this folder'),
    ],
)
def test_one_sentence_says_what_is_not_needed(tmp_path: Any, line: str, part: str) -> None:
    said = answer(line.split(), str(tmp_path))
    assert said is not None and part in said and '\n' not in said


@pytest.mark.parametrize(
    'line', ['', 'sudo', 'apt install vim', 'source ~/.bashrc', 'source', 'rosdep check', 'ls', 'ls missing', 'ls -l /usr']
)
def test_other_commands_are_none_of_ours(line: str) -> None:
    assert answer(line.split()) is None


def test_building_names_what_is_there(workspace: Any) -> None:
    for number in range(7):
        workspace.python(f'robo_{number}')
    said = answer(['colcon', 'build'], str(workspace.folder))
    assert said is not None and 'robo_0, robo_1, robo_2, robo_3, robo_4 and 2 more from the sources' in said
