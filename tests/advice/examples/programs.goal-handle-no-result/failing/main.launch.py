import os
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    here = os.path.dirname(os.path.abspath(__file__))
    return LaunchDescription([
        Node(package='examples_rclpy_minimal_action_server', executable='server'),
        ExecuteProcess(cmd=['python3', os.path.join(here, 'a.py')], output='screen'),
    ])
