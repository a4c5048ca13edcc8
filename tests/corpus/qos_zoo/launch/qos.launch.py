from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='qos_zoo', executable='sender'),
        TimerAction(period=0.5, actions=[Node(package='qos_zoo', executable='receiver')]),
    ])
