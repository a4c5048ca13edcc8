import os
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    urdf = open(os.path.join(os.path.dirname(__file__), 'bot.urdf')).read()
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', namespace='robot1',
             parameters=[{'robot_description': urdf, 'frame_prefix': 'robot1/'}]),
        Node(package='tf2_ros', executable='static_transform_publisher',
             arguments=['--x', '1', '--frame-id', 'map', '--child-frame-id', 'robot1/base_link']),
        Node(package='tf2_ros', executable='tf2_echo', arguments=['map', 'robot1/wheel'], output='screen'),
    ])
