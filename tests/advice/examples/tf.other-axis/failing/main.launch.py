import os
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    here = os.path.dirname(os.path.abspath(__file__))
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '5', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', '{linear: {x: 1.0}, angular: {z: 0.8}}']),
        ExecuteProcess(cmd=['python3', os.path.join(here, 'frames.py')], output='screen'),
    ])
