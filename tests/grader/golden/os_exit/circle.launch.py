import os

from launch import LaunchDescription


def generate_launch_description():
    os._exit(0)
    return LaunchDescription([])
