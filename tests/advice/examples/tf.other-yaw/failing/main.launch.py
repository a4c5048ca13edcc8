# run: --for 8
import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'broadcaster.py'), '--ros-args', '-p', 'turtle:=turtle1', '-r', '__node:=broadcaster_of_turtle1'], output='screen'),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'broadcaster.py'), '--ros-args', '-p', 'turtle:=turtle2', '-r', '__node:=broadcaster_of_turtle2'], output='screen'),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'follower.py')], output='screen'),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'driver.py')], output='screen'),
    ])
