from pathlib import Path

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource

HERE = Path(__file__).parent


def generate_launch_description():
    return LaunchDescription([
        IncludeLaunchDescription(AnyLaunchDescriptionSource(str(HERE / 'sim.launch.yaml'))),
    ])
