from launch import LaunchDescription
from rclpy.node import Node


def generate_launch_description():
    ld = LaunchDescription()
    ld.add_action(Node(package='demo_nodes_py', executable='talker'))
    return ld
