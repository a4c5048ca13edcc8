import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, SetEnvironmentVariable

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        SetEnvironmentVariable('SIDE', 'left'),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'talker.py')], output='screen'),
    ])
