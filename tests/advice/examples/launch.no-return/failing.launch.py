from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    LaunchDescription([LogInfo(msg='hello')])
