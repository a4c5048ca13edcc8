from launch import LaunchDescription
from launch_ros.actions import LifecycleNode, Node


def generate_launch_description():
    return LaunchDescription([
        LifecycleNode(package='lifecycle', executable='lifecycle_talker', name='lc_talker', namespace=''),
        Node(package='lifecycle', executable='lifecycle_listener'),
    ])
