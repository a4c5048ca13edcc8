from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
import os


def generate_launch_description():
    return LaunchDescription([
        IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'child.launch.py'), launch_arguments={'speed': '2.0'}.items()),
    ])
