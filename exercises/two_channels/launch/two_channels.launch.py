"""A node that should count the messages of two channels. At the moment it receives none of them, and never counts beyond 1.

    ros2 launch two_channels two_channels.launch.py first:=red

This file is right; two lines of two_channels/counter.py are wrong. Lesson 0 shows both mistakes. The talkers publish once
a second. After each message, the counter should log how many it has received so far, on both channels together:
"messages: 1", "messages: 2".

Grade it with `edugrade exercises/two_channels`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    first = LaunchConfiguration('first')
    return LaunchDescription([
        DeclareLaunchArgument('first', default_value='red', description='The name of the first channel.'),
        Node(package='demo_nodes_py', executable='talker', namespace=first),
        Node(package='demo_nodes_py', executable='talker', namespace='blue'),
        Node(package='two_channels', executable='counter', parameters=[{'first': first}]),
    ])
