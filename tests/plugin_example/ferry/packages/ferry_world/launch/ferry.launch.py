from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    speed = {'speed': LaunchConfiguration('speed')}
    return LaunchDescription(
        [DeclareLaunchArgument('speed', default_value='1.0'), Node(package='ferry_world', executable='ferry', parameters=[speed])]
    )
