from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='heartbeat', executable='doctor'),
        TimerAction(period=0.25, actions=[Node(package='heartbeat', executable='sender')]),
    ])
