from launch import LaunchDescription
from launch.actions import Shutdown, TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='lab_book', executable='plant', output='screen'),
        Node(package='lab_book', executable='recorder', output='screen', emulate_tty=True),
        TimerAction(period=1.5, actions=[Node(package='lab_book', executable='tuner', output='screen')]),
        TimerAction(period=3.5, actions=[Shutdown(reason='enough measured')]),
    ])
