"""Start the robot at the position that turtlebot3_house.launch.py gives it. edulaunch has only the floor of this world."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, LogInfo
from launch.launch_description_sources import PythonLaunchDescriptionSource


def generate_launch_description():
    share = os.path.join(get_package_share_directory('turtlebot3_gazebo'), 'launch')
    return LaunchDescription(
        [
            DeclareLaunchArgument('x_pose', default_value='-2.0', description='Starting X-position of the robot'),
            DeclareLaunchArgument('y_pose', default_value='-0.5', description='Starting Y-position of the robot'),
            LogInfo(msg='turtlebot3_house: edulaunch has the robot and the floor, but neither the walls nor a laser scanner'),
            IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(share, 'robot_state_publisher.launch.py'))),
            IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(share, 'spawn_turtlebot3.launch.py'))),
        ]
    )
