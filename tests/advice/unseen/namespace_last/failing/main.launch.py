import os

from launch import LaunchDescription
from launch.actions import GroupAction
from launch_ros.actions import Node, PushRosNamespace

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        GroupAction([
            Node(package='turtlesim', executable='turtlesim_node', name='sim'),
            PushRosNamespace('left'),
        ]),
    ])
