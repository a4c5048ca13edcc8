from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', arguments=['--map', '/home/ana/ws/src/robo/maps/office.yaml']),
    ])
