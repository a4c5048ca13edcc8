from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='1.0'),
        LogInfo(msg=['speed ', LaunchConfiguration('speed')]),
        Node(package='turtlesim', executable='turtlesim_node'),
    ])
