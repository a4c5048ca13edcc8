# run: --for 3
from launch import LaunchDescription
from launch.actions import Shutdown, TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', sigterm_timeout='5 s'),
        TimerAction(period=1.0, actions=[Shutdown()]),
    ])
