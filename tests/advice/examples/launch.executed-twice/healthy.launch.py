from launch import LaunchDescription
from launch.actions import ExecuteProcess


def listing():
    return ExecuteProcess(cmd=['ros2', 'node', 'list'])


def generate_launch_description():
    return LaunchDescription([listing(), listing()])
