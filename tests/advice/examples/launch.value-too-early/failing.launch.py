from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('count', default_value='1'),
        *([Node(package='turtlesim', executable='turtlesim_node')] if LaunchConfiguration('count') > '1' else []),
    ])
