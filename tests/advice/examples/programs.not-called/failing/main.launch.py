import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess

HERE = os.path.dirname(__file__)


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'talker.py')]),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'listener.py')]),
    ])
