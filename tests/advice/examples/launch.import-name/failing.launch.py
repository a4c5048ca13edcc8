from launch import LaunchDescription
from launch.actions import LogInfo, IfCondition


def generate_launch_description():
    return LaunchDescription([LogInfo(msg='hello')])
