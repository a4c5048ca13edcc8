"""Somebody says the news, somebody hears it; and neither does what it should. The programs and this file are right.

    ros2 launch news_desk news_desk.launch.py room:=office

What is wrong is what setup.py says about the package: two places. config/news.yaml has the word and the period for hello.

Grade it: edugrade exercises/news_desk        A hint: edugrade exercises/news_desk --hint 1
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    room = LaunchConfiguration('room')
    news = PathJoinSubstitution([FindPackageShare('news_desk'), 'config', 'news.yaml'])
    return LaunchDescription([
        DeclareLaunchArgument('room', default_value='office', description='The namespace of both.'),
        Node(package='news_desk', executable='hello', namespace=room, parameters=[news]),
        Node(package='news_desk', executable='listen', namespace=room),
    ])
