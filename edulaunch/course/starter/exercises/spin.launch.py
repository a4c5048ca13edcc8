"""turtle1 drives a circle. The launch argument speed sets its speed in m/s; it turns at 1 rad/s.

Grade it with `edugrade exercises/spin.launch.py`.
"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument('speed', default_value='1.0'),
            Node(package='turtlesim', executable='turtlesim_node'),
            # TODO 1: publish on /turtle1/cmd_vel, ten times a second
        ]
    )
