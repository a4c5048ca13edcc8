"""Publish the frames of the robot that TURTLEBOT3_MODEL names: burger, waffle (the default) or waffle_pi."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    model = os.environ.get('TURTLEBOT3_MODEL', 'waffle')
    print(f'urdf_file_name : turtlebot3_{model}.urdf')
    path = os.path.join(get_package_share_directory('turtlebot3_gazebo'), 'urdf', f'turtlebot3_{model}.urdf')
    with open(path, encoding='utf-8') as file:
        description = file.read()
    use_sim_time = LaunchConfiguration('use_sim_time', default='false')
    return LaunchDescription(
        [
            DeclareLaunchArgument('use_sim_time', default_value='false', description='Use simulation (Gazebo) clock if true'),
            Node(
                package='robot_state_publisher',
                executable='robot_state_publisher',
                name='robot_state_publisher',
                output='screen',
                parameters=[{'use_sim_time': use_sim_time, 'robot_description': description}],
            ),
        ]
    )
