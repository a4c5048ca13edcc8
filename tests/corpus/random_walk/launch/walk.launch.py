from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        Node(package='random_walk', executable='walker', name='first'),
        Node(package='random_walk', executable='walker', name='second'),
    ])
