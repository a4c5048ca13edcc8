from launch import LaunchDescription
from launch.actions import Shutdown, TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    names = ['polite', 'twice', 'rude', 'external', 'looping', 'signal_handler']
    nodes = [Node(package='goodbyes', executable=n) for n in names]
    return LaunchDescription(nodes + [TimerAction(period=2.2, actions=[Shutdown(reason='lesson over')])])
