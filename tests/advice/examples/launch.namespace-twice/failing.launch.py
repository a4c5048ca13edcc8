from launch import LaunchDescription
from launch.actions import GroupAction
from launch_ros.actions import Node, PushRosNamespace


def generate_launch_description():
    return LaunchDescription([
        PushRosNamespace('robot1'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        PushRosNamespace('robot2'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
    ])
