"""One program publishes the news, another one should log it, but both fail. The programs and this file are right.

    ros2 launch news_desk news_desk.launch.py room:=office

There are two mistakes in setup.py. config/news.yaml sets the word and the period of hello.

Grade it with `edugrade exercises/news_desk`. Add `--hint 1` for a hint.
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
        DeclareLaunchArgument('room', default_value='office', description='The namespace of both nodes.'),
        Node(package='news_desk', executable='hello', namespace=room, parameters=[news]),
        Node(package='news_desk', executable='listen', namespace=room),
    ])
