import os
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    here = os.path.dirname(os.path.realpath(__file__))
    inner = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(os.path.join(here, 'inner.launch.py')),
        launch_arguments={'red': '200'}.items())
    return LaunchDescription([inner])
