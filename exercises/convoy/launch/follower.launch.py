"""Everything that one follower needs: its turtle, a carrot 1 m behind its leader, its broadcaster, and its node."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    me, leader = LaunchConfiguration('me'), LaunchConfiguration('leader')
    return LaunchDescription([
        DeclareLaunchArgument('me', description='The turtle that follows.'),
        DeclareLaunchArgument('leader', description='The turtle that it follows.'),
        ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn',
                            ['{x: 2.0, y: 2.0, name: ', me, '}']]),
        Node(package='tf2_ros', executable='static_transform_publisher', name=['carrot_of_', leader],
             arguments=['--x', '-1', '--frame-id', leader, '--child-frame-id', ['carrot_', leader]]),
        # TODO 1: the broadcaster, and the node follower of convoy, which drives to ['carrot_', leader]

    ])
