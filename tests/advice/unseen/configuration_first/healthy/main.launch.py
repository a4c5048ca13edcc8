import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('who', default_value='sim'),
        Node(package='turtlesim', executable='turtlesim_node', name=LaunchConfiguration('who')),
    ])
