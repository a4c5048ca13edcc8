from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='cmake_robot', executable='planner.py'),
        Node(package='cmake_robot', executable='driver.py', output='screen'),
    ])
