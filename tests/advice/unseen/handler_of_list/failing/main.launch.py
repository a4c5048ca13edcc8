import os

from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessStart
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node')
    return LaunchDescription([
        sim,
        RegisterEventHandler(OnProcessStart(target_action=[sim], on_start=[LogInfo(msg='started')])),
    ])
