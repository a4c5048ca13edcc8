from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='part3_beyond_basic', executable='param_circle.py'),
    ])
