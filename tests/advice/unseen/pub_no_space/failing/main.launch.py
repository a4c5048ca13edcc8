from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=['ros2', 'topic', 'pub', '--rate', '1', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', '{linear:{x:0.2}, angular:{z:0.5}}'], output='screen'),
    ])
