"""Runs one Python program."""

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', LaunchConfiguration('file')])])
