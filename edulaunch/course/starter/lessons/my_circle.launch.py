from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    twist = '{linear: {x: 1.0}, angular: {z: 1.0}}'
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '10', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', twist]),
    ])
