from launch import LaunchDescription
from launch_ros.actions import LifecycleNode, Node


def generate_launch_description():
    return LaunchDescription([
        LifecycleNode(package='conductor', executable='player', name='player', namespace=''),
        Node(package='conductor', executable='conductor'),
    ])
