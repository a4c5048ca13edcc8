from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='arguments', executable='with_argparse', arguments=['--speed', '2.5', 'leo']),
        Node(package='arguments', executable='with_argparse', arguments=['--sped', '2.5'], name='typo'),
        Node(package='arguments', executable='known_only', arguments=['-n', '4'], name='known'),
        Node(package='arguments', executable='known_only', name='missing'),
        Node(package='arguments', executable='plain_argv', arguments=['3.5', 'b']),
        Node(package='arguments', executable='plain_argv'),
    ])
