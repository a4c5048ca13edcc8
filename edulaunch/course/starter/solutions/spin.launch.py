"""turtle1 drives a circle. The launch argument speed sets its speed in m/s; it turns at 1 rad/s."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    twist = ['{linear: {x: ', LaunchConfiguration('speed'), '}, angular: {z: 1.0}}']
    return LaunchDescription(
        [
            DeclareLaunchArgument('speed', default_value='1.0'),
            Node(package='turtlesim', executable='turtlesim_node'),
            ExecuteProcess(cmd=['ros2', 'topic', 'pub', '-r', '10', '/turtle1/cmd_vel', 'geometry_msgs/msg/Twist', twist]),
        ]
    )
