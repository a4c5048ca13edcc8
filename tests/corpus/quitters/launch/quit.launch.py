from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='quitters', executable='in_timer'),
        Node(package='quitters', executable='publish_after'),
        Node(package='quitters', executable='destroys'),
        Node(package='quitters', executable='init_twice'),
        Node(package='quitters', executable='done_callback'),
    ])
