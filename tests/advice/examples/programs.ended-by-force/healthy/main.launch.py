# run: --for 12
import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, Shutdown, TimerAction

HERE = os.path.dirname(__file__)


def generate_launch_description():
    return LaunchDescription(
        [
            ExecuteProcess(cmd=['python3', os.path.join(HERE, 'worker.py')]),
            TimerAction(period=2.0, actions=[Shutdown()]),
        ]
    )
