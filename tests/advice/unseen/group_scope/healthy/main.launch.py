import os

from launch import LaunchDescription
from launch.actions import GroupAction, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        GroupAction([SetLaunchConfiguration('red', '200')], scoped=False),
        Node(package='turtlesim', executable='turtlesim_node', parameters=[{'background_r': LaunchConfiguration('red')}]),
    ])
