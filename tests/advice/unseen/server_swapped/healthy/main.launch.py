from pathlib import Path

from launch import LaunchDescription
from launch.actions import ExecuteProcess

HERE = Path(__file__).parent


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['ros2', 'service', 'call', '/add', 'example_interfaces/srv/AddTwoInts', '{a: 1, b: 2}']),
        ExecuteProcess(cmd=['python3', str(HERE / 'walker.py')], output='screen'),
    ])
