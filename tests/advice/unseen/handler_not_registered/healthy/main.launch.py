import os

from launch import LaunchDescription
from launch_ros.actions import Node
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessStart

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        RegisterEventHandler(OnProcessStart(on_start=[LogInfo(msg='started')])),
    ])
