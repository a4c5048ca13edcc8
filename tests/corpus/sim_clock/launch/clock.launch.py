from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='sim_clock', executable='stopwatch', parameters=[{'use_sim_time': True}]),
        Node(package='sim_clock', executable='clock'),
        Node(package='sim_clock', executable='types'),
    ])
