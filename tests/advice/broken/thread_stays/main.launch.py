import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, Shutdown, TimerAction


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', os.path.join(os.path.dirname(__file__), 'watch.py')], output='screen'),
        TimerAction(period=2.0, actions=[Shutdown()]),
    ])
