from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='tf2_ros', executable='static_transform_publisher', name='a', arguments=['--frame-id', 'world', '--child-frame-id', 'camera']),
        Node(package='tf2_ros', executable='static_transform_publisher', name='b', arguments=['--frame-id', 'base_link', '--child-frame-id', 'camera']),
    ])
