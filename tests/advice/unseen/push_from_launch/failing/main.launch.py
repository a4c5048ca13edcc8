import os

from launch import LaunchDescription
from launch_ros.actions import Node
from launch.actions import PushRosNamespace

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        PushRosNamespace('red'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
    ])
