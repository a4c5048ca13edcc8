from launch import LaunchDescription
from launch.actions import RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node')
    driver = Node(package='turtlesim', executable='draw_square')
    return LaunchDescription([
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[driver])),
        TimerAction(period=1.0, actions=[sim]),
    ])
