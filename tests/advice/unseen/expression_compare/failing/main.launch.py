from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('count', default_value='4'),
        Node(package='turtlesim', executable='turtlesim_node', condition=IfCondition(PythonExpression(LaunchConfiguration('count') > 3))),
    ])
