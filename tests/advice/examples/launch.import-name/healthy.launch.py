from launch import LaunchDescription
from launch.actions import LogInfo
from launch.conditions import IfCondition


def generate_launch_description():
    return LaunchDescription([LogInfo(msg='hello')])
