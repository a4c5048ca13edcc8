from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='robo', executable='talker', output='screen'),
        Node(package='robo', executable='watcher', output='screen'),
    ])
