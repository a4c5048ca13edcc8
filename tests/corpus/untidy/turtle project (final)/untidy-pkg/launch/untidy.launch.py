from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='untidy_pkg', executable='tabs'),
        Node(package='untidy_pkg', executable='try2'),
        Node(package='untidy_pkg', executable='random'),
        Node(package='untidy_pkg', executable='turtle'),
    ])
