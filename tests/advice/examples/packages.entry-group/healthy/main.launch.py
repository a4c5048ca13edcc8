from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='week3', executable='hello'),
        Node(package='week3', executable='hear'),
    ])
