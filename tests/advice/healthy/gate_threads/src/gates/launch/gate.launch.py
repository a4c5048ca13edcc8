from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='gates', executable='gate'),
        ExecuteProcess(cmd=['ros2', 'service', 'call', '/open_gate', 'std_srvs/srv/Trigger']),
    ])
