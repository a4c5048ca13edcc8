from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('red', default_value='0'),
        Node(package='turtlesim', executable='turtlesim_node', parameters=[{'background_r': LaunchConfiguration('red')}]),
    ])
