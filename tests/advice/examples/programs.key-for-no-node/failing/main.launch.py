import os

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    params = os.path.join(os.path.dirname(__file__), 'params.yaml')
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', parameters=[params]),
    ])
