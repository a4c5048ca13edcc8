import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node')
    spawn = ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{x: 2.0, y: 2.0}'])
    return LaunchDescription([
        sim,
        spawn,
        RegisterEventHandler(OnProcessExit(target_action=spawn, on_exit=[ExecuteProcess(cmd=['python3', os.path.join(HERE, 'driver.py')])])),
    ])
