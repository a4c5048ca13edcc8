import os

from launch import LaunchDescription
from launch_ros.actions import Node
from launch.actions import ExecuteProcess

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', remappings=[('turtle1/cmd_vel', 'drive')]),
        ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '2', '/drive', 'geometry_msgs/msg/Twist', '{angular: {z: 1.0}}']),
    ])
