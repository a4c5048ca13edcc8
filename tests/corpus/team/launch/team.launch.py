from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='team', executable='team', parameters=[{'greeting': 'hey'}]),
        Node(package='team', executable='team', name='renamed'),
    ])
