from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=['ros2', 'service', 'call', '/turtle1/teleport_absolute', 'turtlesim/srv/TeleportAbsolute', '{x: 20.0, y: 5.0, theta: 0.0}']),
    ])
