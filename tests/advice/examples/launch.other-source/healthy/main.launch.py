from pathlib import Path

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch_xml.launch_description_sources import XMLLaunchDescriptionSource

HERE = Path(__file__).parent


def generate_launch_description():
    return LaunchDescription([
        IncludeLaunchDescription(XMLLaunchDescriptionSource(str(HERE / 'sim.launch.xml'))),
    ])
