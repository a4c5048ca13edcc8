"""Start a service and a client whose calls `ros2 service echo` can show."""

from launch import LaunchDescription
from launch.actions import Shutdown
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package='demo_nodes_cpp', executable='introspection_service', output='screen'),
            Node(package='demo_nodes_cpp', executable='introspection_client', output='screen', on_exit=Shutdown()),
        ]
    )
