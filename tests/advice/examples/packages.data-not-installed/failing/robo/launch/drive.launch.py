import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    wheels = os.path.join(get_package_share_directory('robo'), 'config', 'wheels.yaml')
    return LaunchDescription([Node(package='robo', executable='drive', parameters=[wheels])])
