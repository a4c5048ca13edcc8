import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, Shutdown, TimerAction
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'talker.py')], output='screen'),
        Node(package='turtlesim', executable='turtlesim_node', on_exit=Shutdown()),
        TimerAction(period=1.0, actions=[ExecuteProcess(cmd=['ros2', 'node', 'list'], on_exit=Shutdown)]),
    ])
