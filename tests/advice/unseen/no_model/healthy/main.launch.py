import os

from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    model = os.environ.get('TURTLEBOT3_MODEL', 'burger')
    return LaunchDescription([
        LogInfo(msg=f'model {model}'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
    ])
