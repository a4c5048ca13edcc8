from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        Node(package='event_loops', executable='mission', output='screen'),
        Node(package='event_loops', executable='bridge', output='screen'),
    ])
