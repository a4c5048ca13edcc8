"""A talker and two listeners, and neither listener receives a message. ROS 2 reports no error.

    ros2 launch silent_listener.launch.py

Do not change the talker: it publishes on /news/chatter. Both listeners should receive its messages, and keep their names
and namespaces. There are two mistakes.

Grade it with `edugrade exercises/silent_listener.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    house = LaunchConfiguration('house')
    return LaunchDescription([
        DeclareLaunchArgument('house', default_value='flat', description='The namespace of the second listener.'),
        Node(package='demo_nodes_py', executable='talker', namespace='news'),
        Node(package='demo_nodes_py', executable='listener', name='radio', remappings=[('chatter', '/news/chatter')]),
        Node(package='demo_nodes_py', executable='listener', namespace=house, remappings=[('chatter', '/news/chatter')]),
    ])
