"""What package.xml asks for and nobody has."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.advice.workspace.dependencies import is_here, missing_dependencies
from edulaunch.engine.packages import Index


def test_each_missing_dependency_is_named_once_with_its_line_and_the_nearest_name(workspace: Any) -> None:
    workspace.python('robo', depends='rclpy geometry_mgs nav2_bringup robo_msgs geometry_mgs')
    workspace.interfaces('robo_msgs', msg_Part='string name')
    packages, missing = missing_dependencies(str(workspace.folder))
    assert packages == ['robo', 'robo_msgs']
    assert [(row.package.name, row.dependency.name, row.dependency.line, row.nearest) for row in missing] == [
        ('robo', 'geometry_mgs', 4, 'geometry_msgs'),
        ('robo', 'nav2_bringup', 5, None),
    ]


@pytest.mark.parametrize(
    ('name', 'here'),
    [
        ('launch', True),
        ('turtlesim', True),
        ('rosidl_default_generators', True),
        ('rclcpp', True),
        ('tf2_ros_py', True),
        ('python3-numpy', True),
        ('python3-yaml', True),
        ('python3-no-such-thing', False),
        ('gazebo_ros', False),
        ('ros2_control', False),
        ('ros2launch', True),
        ('rclcpp_lifecycle', True),
        ('ament_cmake_auto', True),
        ('xacro', True),
    ],
)
def test_what_counts_as_here(name: str, here: bool) -> None:
    assert is_here(name, list(Index().packages())) is here
