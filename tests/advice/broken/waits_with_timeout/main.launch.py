import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', os.path.join(os.path.dirname(__file__), 'where.py')], output='screen'),
    ])
