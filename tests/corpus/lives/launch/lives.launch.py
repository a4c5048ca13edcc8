from launch import LaunchDescription
from launch.actions import EmitEvent, LogInfo, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit, OnShutdown
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='lives', executable='mayfly', respawn=True, respawn_delay=0.5),
        Node(package='lives', executable='worker'),
        Node(package='lives', executable='boss', on_exit=Shutdown(reason='the boss has left')),
        RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg='shutting down')])),
    ])
