from launch import LaunchDescription
from launch.actions import EmitEvent, RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch.events import Shutdown
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node')
    square = Node(package='turtlesim', executable='draw_square')
    return LaunchDescription([
        sim, square,
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[EmitEvent(event=Shutdown(reason='window closed'))])),
    ])
