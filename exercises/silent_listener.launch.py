"""A talker and two listeners, and neither of them hears a word. Nothing reports an error.

    ros2 launch silent_listener.launch.py

The talker stays as it is: it speaks on /news/chatter. Both listeners shall hear it, and keep their names and namespaces.
Two places are wrong.

Grade it: edugrade exercises/silent_listener.launch.py        A hint: edugrade exercises/silent_listener.launch.py --hint 1
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
        # TODO 1: /radio shall hear the talker
        Node(package='demo_nodes_py', executable='listener', name='radio', remappings=[('/news/chatter', 'chatter')]),
        # TODO 2: so shall the listener in the house
        Node(package='demo_nodes_py', executable='listener', namespace=house, remappings=[('/chatter', '/news/chatter')]),
    ])
