from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_py', executable='talker', parameters=[{'use_sim_time': True}]),
        Node(package='demo_nodes_py', executable='listener'),
    ])
