from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    ld = LaunchDescription()
    talker = Node(package='demo_nodes_py', executable='talker')
    listener = Node(package='demo_nodes_py', executable='listener')
    ld.add_action(talker)
    ld.add_action(listener)
    return ld
