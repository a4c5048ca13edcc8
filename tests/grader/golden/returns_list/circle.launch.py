from launch_ros.actions import Node


def generate_launch_description():
    return [
        Node(package='turtlesim', executable='turtlesim_node'),
    ]
