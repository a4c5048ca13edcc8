from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('policy', default_value='preempt', choices=['preempt', 'queue']),
        Node(package='axis', executable='axis_server', parameters=[{'policy': LaunchConfiguration('policy')}]),
        Node(package='axis', executable='axis_client'),
    ])
