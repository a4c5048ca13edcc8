from launch import LaunchDescription
from launch.actions import LogInfo


def generate_test_description():
    return LaunchDescription([LogInfo(msg='hello')])
