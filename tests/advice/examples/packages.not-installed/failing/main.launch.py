from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    with open(get_package_share_directory('robot') + '/config/arm.yaml') as file:
        return LaunchDescription([LogInfo(msg=file.read())])
