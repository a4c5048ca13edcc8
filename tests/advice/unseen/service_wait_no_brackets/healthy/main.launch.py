from pathlib import Path

from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node

HERE = Path(__file__).parent


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', str(HERE / 'walker.py')], output='screen'),
        TimerAction(period=1.5, actions=[Node(package='demo_nodes_py', executable='add_two_ints_server')]),
    ])
