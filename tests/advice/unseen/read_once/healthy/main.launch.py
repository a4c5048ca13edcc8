import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'driver.py')], output='screen'),
        TimerAction(period=2.0, actions=[ExecuteProcess(cmd=['ros2', 'param', 'set', '/driver', 'speed', '1.0'])]),
    ])
