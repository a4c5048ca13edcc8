import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', os.path.join(os.path.dirname(__file__), 'driver.py')], output='screen'),
        TimerAction(period=1.0, actions=[Node(package='turtlesim', executable='turtlesim_node', name='sim')]),
    ])
