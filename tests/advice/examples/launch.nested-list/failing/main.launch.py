from pathlib import Path

from launch import LaunchDescription
from launch_ros.actions import Node

PARAMETERS = str(Path(__file__).parent / 'route.yaml')


def generate_launch_description():
    return LaunchDescription([Node(package='demo_nodes_py', executable='talker', parameters=[PARAMETERS])])
