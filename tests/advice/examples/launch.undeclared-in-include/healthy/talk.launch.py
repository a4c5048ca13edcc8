from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('topic', default_value='chatter'),
        Node(package='demo_nodes_py', executable='talker', remappings=[('chatter', LaunchConfiguration('topic'))]),
        Node(package='demo_nodes_py', executable='listener', remappings=[('chatter', LaunchConfiguration('topic'))]),
    ])
