import os

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """One file for all: that it has nothing for the second node is meant so."""
    params = os.path.join(os.path.dirname(__file__), 'params.yaml')
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', parameters=[params], remappings=[('turtle1/cmd_vel', 'cmd_vel')]),
        Node(package='demo_nodes_py', executable='talker', parameters=[params]),
        Node(package='demo_nodes_py', executable='listener'),
    ])
