from launch import LaunchDescription
from launch.actions import LogInfo
from .shared import x


def generate_launch_description():
    return LaunchDescription([LogInfo(msg='hello')])
