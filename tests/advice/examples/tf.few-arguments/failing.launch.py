from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package='tf2_ros', executable='static_transform_publisher', arguments=['0.1', '0', '0.2', '1.57', '0', '0']),
        ]
    )
