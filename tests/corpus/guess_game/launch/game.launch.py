from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='guess_game', executable='scoreboard'),
        Node(package='guess_game', executable='game', prefix='xterm -e', output='screen'),
        Node(package='guess_game', executable='menu', emulate_tty=True),
        Node(package='guess_game', executable='menu', name='nobody_there'),
    ])
