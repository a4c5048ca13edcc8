import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription


def generate_launch_description():
    file = os.path.join(get_package_share_directory('robo'), 'launch', 'hall.launch.py')
    return LaunchDescription([IncludeLaunchDescription(file)])
