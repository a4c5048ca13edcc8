import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node
from launch.substitutions import Command
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    path = os.path.join(get_package_share_directory('my_robot'), 'urdf', 'cart.urdf.xacro')
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': ParameterValue(Command(['xacro ', path]), value_type=str)}]),
    ])
