# run: backgrond_g:=100
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('background_g', default_value='50'),
        Node(package='turtlesim', executable='turtlesim_node', parameters=[{'background_g': 20}]),
    ])
