from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def make_robots(context):
    count = int(LaunchConfiguration('count').perform(context))
    nodes = [
        Node(package='turtlesim', executable='turtlesim_node', namespace=f'robot{index}') for index in range(count)
    ]
    return nodes


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('count', default_value='2'), OpaqueFunction(function=make_robots)])
