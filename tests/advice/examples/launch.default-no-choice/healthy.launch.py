from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('auto', default_value='true', choices=['true', 'false']),
        Node(package='turtlesim', executable='turtlesim_node', name=['sim_', LaunchConfiguration('auto')]),
    ])
