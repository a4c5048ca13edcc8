import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    share = get_package_share_directory('nav2_bringup')
    with open(os.path.join(share, 'package.xml')) as file:
        return LaunchDescription([LogInfo(msg=file.read())])
