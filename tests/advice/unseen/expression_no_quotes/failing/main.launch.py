from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('mode', default_value='sim'),
        Node(
            package='turtlesim',
            executable='turtlesim_node',
            name='sim',
            condition=IfCondition(PythonExpression([LaunchConfiguration('mode'), " == 'sim'"])),
        ),
    ])
