from launch import LaunchDescription
from launch.actions import RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node


def generate_launch_description():
    recorder = Node(package='tape', executable='tape_recorder')
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='tape', executable='puppet', arguments=['geometry_msgs/msg/Twist']),
        recorder,
        RegisterEventHandler(OnProcessExit(target_action=recorder, on_exit=[Shutdown(reason='tape is full')])),
    ])
