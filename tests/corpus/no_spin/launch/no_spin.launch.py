from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='no_spin', executable='sender'),
        Node(package='no_spin', executable='reader'),
        Node(package='no_spin', executable='spins_itself'),
    ])
