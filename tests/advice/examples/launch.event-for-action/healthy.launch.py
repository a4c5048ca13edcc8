from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.actions import Shutdown
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        ExecuteProcess(cmd=['sleep', '1'], on_exit=Shutdown(reason='done')),
    ])
