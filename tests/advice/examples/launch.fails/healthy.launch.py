import math

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    sides = [3, 4, 5]
    turns = [2 * math.pi / side for side in sides]
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name=f'sim{number}') for number in range(len(turns))
    ])
