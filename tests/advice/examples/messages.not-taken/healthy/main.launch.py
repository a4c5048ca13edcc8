# run: --for 14
import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

HERE = os.path.dirname(__file__)


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package='demo_nodes_py', executable='talker'),
            ExecuteProcess(cmd=['python3', os.path.join(HERE, 'listener.py')]),
        ]
    )
