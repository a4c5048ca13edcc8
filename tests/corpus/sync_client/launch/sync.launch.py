from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='sync_client', executable='server'),
        Node(package='sync_client', executable='client'),
        Node(package='sync_client', executable='threaded_client'),
    ])
