from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import EqualsSubstitution, LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('mode', default_value='draw', choices=['draw', 'wait']),
        Node(
            package='turtlesim',
            executable='draw_square',
            condition=IfCondition(EqualsSubstitution(LaunchConfiguration('mode'), 'draw')),
        ),
    ])
