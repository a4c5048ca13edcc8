import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    move = ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{x: 2.0, y: 2.0}'])
    return LaunchDescription([
        move,
        RegisterEventHandler(OnProcessExit(target_action=move, on_exit=[LogInfo(msg='moved')])),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
    ])
