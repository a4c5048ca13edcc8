import os
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    here = os.path.dirname(os.path.abspath(__file__))
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', os.path.join(here, 'two.py')], output='screen'),
    ])
