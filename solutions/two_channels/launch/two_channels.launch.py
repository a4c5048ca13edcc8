"""A node that counts what is said on two channels. It counts neither of them, and never comes beyond 1.

    ros2 launch two_channels two_channels.launch.py first:=red

This file is right; two lines of two_channels/counter.py are wrong. Lesson 0 has both mistakes. The talkers speak once a second,
and after each message the counter says how many it has heard so far, of both channels together: "messages: 1", "messages: 2".

Grade it: edugrade exercises/two_channels        A hint: edugrade exercises/two_channels --hint 1
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
