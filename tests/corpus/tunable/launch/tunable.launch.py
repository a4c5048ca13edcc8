from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node


def later(seconds, *words):
    return TimerAction(period=seconds, actions=[
        ExecuteProcess(cmd=[['ros2 param set ', '/my_blinker ', ' '.join(words)]], shell=True)])


def generate_launch_description():
    return LaunchDescription([
        Node(package='tunable', executable='blinker', name='my_blinker', parameters=[{'word': 'hello', 'led.number': 1}]),
        Node(package='tunable', executable='undeclared'),
        Node(package='tunable', executable='blinker', name='broken', parameters=[{'period': 2}]),
        Node(package='tunable', executable='blinker', name='too_fast', parameters=[{'period': 0.01}]),
        later(2.5, 'period', '0.5'),
        later(3.2, 'word', 'forbidden'),
        later(3.4, 'period', '1'),
        later(3.6, 'period', '9.5'),
        later(3.8, 'nothing', '1'),
    ])
