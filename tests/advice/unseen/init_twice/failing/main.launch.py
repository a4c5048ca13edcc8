import os

from launch import LaunchDescription
from launch_ros.actions import Node
from launch.actions import ExecuteProcess

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'walker.py')], output='screen'),
    ])
