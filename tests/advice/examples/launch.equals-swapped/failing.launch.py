from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import LaunchConfigurationEquals
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('who', default_value='talker'),
        Node(package='demo_nodes_py', executable='talker', condition=LaunchConfigurationEquals('talker', 'who')),
    ])
