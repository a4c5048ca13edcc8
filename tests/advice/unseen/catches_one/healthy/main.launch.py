from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='robo', executable='moves'),
        Node(package='robo', executable='driver', output='screen'),
    ])
