import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', os.path.join(os.path.dirname(__file__), 'ear.py')], output='screen'),
        Node(package='demo_nodes_py', executable='talker'),
    ])
