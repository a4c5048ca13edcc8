from launch import LaunchDescription
from launch.actions import EmitEvent, TimerAction
from launch.events import Shutdown
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_py', executable='talker'),
        Node(package='demo_nodes_py', executable='listener'),
        TimerAction(period=3.0, actions=[EmitEvent(event=Shutdown)]),
    ])
