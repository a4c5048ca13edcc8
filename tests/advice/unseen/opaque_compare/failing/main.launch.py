import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def more(context):
    mode = LaunchConfiguration('mode')
    if mode == 'drive':
        return [ExecuteProcess(cmd=['python3', os.path.join(HERE, 'driver.py')])]
    return []


HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        DeclareLaunchArgument('mode', default_value='drive'),
        OpaqueFunction(function=more),
    ])
