from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='async_nodes', executable='server'),
        Node(package='async_nodes', executable='adder'),
        Node(package='async_nodes', executable='asker'),
    ])
