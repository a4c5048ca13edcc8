from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')
    return LaunchDescription([
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[LogInfo(msg='it runs')])),
        sim,
    ])
