import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='arena1'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='arena2'),
        Node(package='my_robot', executable='driver', name='driver', output='screen', namespace='arena1'),
        Node(package='turtlesim', executable='mimic', name='mimic', remappings=[('/arena1/turtle1/pose', '/input/pose'), ('/arena2/turtle1/cmd_vel', '/output/cmd_vel')]),
    ])
