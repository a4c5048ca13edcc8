from launch import LaunchDescription
from launch.actions import GroupAction
from launch_ros.actions import Node, PushRosNamespace


def generate_launch_description():
    return LaunchDescription([
        GroupAction([PushRosNamespace('robot1'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim')]),
        GroupAction([PushRosNamespace('robot2'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim')]),
    ])
