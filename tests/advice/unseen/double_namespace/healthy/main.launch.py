import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, GroupAction
from launch_ros.actions import Node, PushRosNamespace

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        GroupAction([
            PushRosNamespace('left'),
            Node(package='turtlesim', executable='turtlesim_node'),
        ]),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'driver.py')], output='screen'),
    ])
