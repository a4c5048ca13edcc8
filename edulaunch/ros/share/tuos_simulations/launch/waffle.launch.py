"""Start a TurtleBot3 Waffle on an empty plane. Launch arguments set its initial position and orientation."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, LogInfo
from launch.conditions import IfCondition
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    share = get_package_share_directory('turtlebot3_gazebo')
    spawn = os.path.join(share, 'launch', 'spawn_turtlebot3.launch.py')
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                'with_gui',
                default_value='true',
                description='Select whether to launch Gazebo with or without Gazebo Client (i.e. the GUI).',
            ),
            DeclareLaunchArgument('x_pose', default_value='0.0', description='Starting X-position of the robot'),
            DeclareLaunchArgument('y_pose', default_value='0.0', description='Starting Y-position of the robot'),
            DeclareLaunchArgument('yaw', default_value='0.0', description='Starting orientation of the robot (radians)'),
            LogInfo(
                msg='with_gui: edulaunch opens no Gazebo window; the pictures come from the recording',
                condition=IfCondition(LaunchConfiguration('with_gui')),
            ),
            IncludeLaunchDescription(PythonLaunchDescriptionSource(spawn)),
        ]
    )
