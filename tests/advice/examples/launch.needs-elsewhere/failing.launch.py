from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    share = get_package_share_directory('orchard_rover_description')
    return LaunchDescription([LogInfo(msg='found' if share else 'lost')])
