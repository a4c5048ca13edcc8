import os

from launch import LaunchDescription
from launch_ros.actions import Node, SetParameter


def generate_launch_description():
    params = os.path.join(os.path.dirname(__file__), 'params.yaml')
    return LaunchDescription([
        SetParameter('use_sim_time', False),
        Node(
            package='turtlesim',
            executable='turtlesim_node',
            name='sim',
            parameters=[params, {'background_g': 7}],
        ),
    ])
