from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node
import os


def generate_launch_description():
    config = os.path.join(get_package_share_directory('robo'), '/config/robo.yaml')
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        Node(package='robo', executable='driver', parameters=[config]),
    ])
