"""Start a TurtleBot3 Waffle on an empty plane."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    share = get_package_share_directory('turtlebot3_gazebo')
    spawn = os.path.join(share, 'launch', 'spawn_turtlebot3.launch.py')
    return LaunchDescription(
        [
            DeclareLaunchArgument('x_pose', default_value='0.0', description='Starting X-position of the robot'),
            DeclareLaunchArgument('y_pose', default_value='0.0', description='Starting Y-position of the robot'),
            IncludeLaunchDescription(PythonLaunchDescriptionSource(spawn)),
        ]
    )
