from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    listing = ExecuteProcess(cmd=['ros2', 'node', 'list'])
    return LaunchDescription([listing, listing])
