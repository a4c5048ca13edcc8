from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_py', executable='talker', namespace='robot1'),
        Node(package='demo_nodes_py', executable='listener', remappings=[('chatter', 'robot/chatter')]),
    ])
