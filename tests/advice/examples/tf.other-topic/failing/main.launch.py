import os
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    here = os.path.dirname(os.path.abspath(__file__))
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', namespace='bot1'),
        Node(executable='python3', arguments=[os.path.join(here, 'caster.py')], namespace='bot1', remappings=[('/tf', 'tf'), ('/tf_static', 'tf_static')]),
        Node(executable='python3', arguments=[os.path.join(here, 'look.py')], output='screen'),
    ])
