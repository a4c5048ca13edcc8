import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='b1', parameters=[{'turtlename': 'turtle1'}]),
        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='b2', parameters=[{'turtlename': 'turtle2'}]),
        ExecuteProcess(cmd=['ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{x: 2.0, y: 2.0, name: turtle2}']),
        Node(package='turtlesim', executable='draw_square', name='square'),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'follow.py')], output='screen'),
    ])
