import os

from launch import LaunchDescription
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--x', '0.2', '--frame-id', 'base_link', '--child-frame-id', 'laser']),
    ])
