import os

from launch import LaunchDescription
from launch_ros.actions import Node, SetParameter

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        SetParameter('background_r', 200),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
    ])
