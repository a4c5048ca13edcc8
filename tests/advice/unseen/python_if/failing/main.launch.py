import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    drive = LaunchConfiguration('drive')
    programs = []
    if drive == 'true':
        programs = [ExecuteProcess(cmd=['python3', os.path.join(HERE, 'driver.py')])]
    return LaunchDescription(programs + [
        DeclareLaunchArgument('drive', default_value='true'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
    ])
