from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    nodes = []
    for kind, seconds in [('same', '0.6'), ('own', '1.5'), ('reentrant', '1.5')]:
        nodes.append(Node(package='groups', executable='timers', arguments=[kind, seconds]))
    return LaunchDescription(nodes)
