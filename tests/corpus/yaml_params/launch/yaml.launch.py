import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import GroupAction
from launch_ros.actions import Node, PushRosNamespace


def generate_launch_description():
    config = os.path.join(get_package_share_directory('yaml_params'), 'config', 'all.yaml')
    return LaunchDescription([
        Node(package='yaml_params', executable='show', name='one', parameters=[config]),
        Node(package='yaml_params', executable='show', name='two', parameters=[config, {'color': 'white'}]),
        GroupAction([
            PushRosNamespace('farm'),
            Node(package='yaml_params', executable='show', name='one', parameters=[config]),
        ]),
        Node(package='yaml_params', executable='show', name='two', namespace='farm/north',
             parameters=[{'color': 'white', 'list': [1, 2]}, config]),
    ])
