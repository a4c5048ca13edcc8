"""Start a node that publishes on `chatter`, and a node that subscribes to it."""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [Node(package='demo_nodes_cpp', executable=program, output='screen') for program in ('talker', 'listener')]
    )
