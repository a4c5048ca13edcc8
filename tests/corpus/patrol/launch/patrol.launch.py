from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='patrol', executable='patrol'),
        TimerAction(period=0.7, actions=[Node(package='turtlesim', executable='turtlesim_node')]),
    ])
