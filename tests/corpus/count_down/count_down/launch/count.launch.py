from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node


def client(number, name):
    return Node(package='count_down', executable='count_until_client', arguments=[str(number)], name=name)


def generate_launch_description():
    return LaunchDescription([
        Node(package='count_down', executable='count_until_server'),
        client(-1, 'refused'),
        TimerAction(period=1.0, actions=[client(3, 'happy')]),
        TimerAction(period=4.0, actions=[client(9, 'impatient')]),
        TimerAction(period=8.0, actions=[client(2, 'unlucky')]),
    ])
