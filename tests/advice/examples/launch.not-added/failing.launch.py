from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node')
    square = Node(package='turtlesim', executable='draw_square')
    return LaunchDescription([sim])
