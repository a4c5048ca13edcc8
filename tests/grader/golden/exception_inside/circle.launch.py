from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    radius = {'small': 0.5}['large']
    return LaunchDescription([
        Node(package='part3_beyond_basics', executable='param_circle.py'),
    ])
