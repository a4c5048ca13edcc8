from launch import LaunchDescription
from launch.actions import Shutdown, TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_py', executable='talker'),
        Node(package='demo_nodes_py', executable='listener'),
        Shutdown(),
    ])
