"""Start two turtle windows, each in its own namespace."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package='turtlesim', executable='turtlesim_node', namespace=namespace, output='screen')
            for namespace in ('turtlesim1', 'turtlesim2')
        ]
    )
