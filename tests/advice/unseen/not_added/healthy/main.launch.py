import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node')
    driver = ExecuteProcess(cmd=['python3', os.path.join(HERE, 'driver.py')])
    return LaunchDescription([
        sim,
        driver,
    ])
