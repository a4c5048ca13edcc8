from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('who', default_value='leo'),
        LogInfo(msg=['hello ', LaunchConfiguration('who')] ),
        Node(package='turtlesim', executable='turtlesim_node'),
    ])
