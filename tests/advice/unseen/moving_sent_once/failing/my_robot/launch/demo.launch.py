import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='my_robot', executable='driver', name='driver', output='screen'),
        Node(package='my_robot', executable='broadcaster', name='broadcaster1', parameters=[{'turtlename': 'turtle1'}]),
        Node(package='my_robot', executable='broadcaster', name='broadcaster2', parameters=[{'turtlename': 'turtle2'}]),
        Node(package='my_robot', executable='listener', name='listener', output='screen'),
        Node(package='my_robot', executable='sensor', name='sensor', output='screen'),
    ])
