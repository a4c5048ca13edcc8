"""Put the robot into the world at x_pose, y_pose (metres) and yaw (radians). The default of each is 0.0."""

import os

from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    model = os.environ.get('TURTLEBOT3_MODEL', 'waffle')
    print(f'urdf_file_name : turtlebot3_{model}.urdf')
    pose = {
        name: ParameterValue(LaunchConfiguration(name, default='0.0'), value_type=float) for name in ('x_pose', 'y_pose', 'yaw')
    }
    return LaunchDescription(
        [Node(package='turtlebot3_gazebo', executable='waffle_simulator', parameters=[pose], output='screen')]
    )
