from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch_ros.actions import Node


def setup(context):
    return [Node(package='turtlesim', executable='turtlesim_node')]


def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=setup)])
