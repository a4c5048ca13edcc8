"""Start the empty world with a robot that drives in a circle."""

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    world = PathJoinSubstitution([FindPackageShare('turtlebot3_gazebo'), 'launch', 'empty_world.launch.py'])
    return LaunchDescription(
        [
            IncludeLaunchDescription(PythonLaunchDescriptionSource(world)),
            Node(package='part3_beyond_basics', executable='param_circle.py', name='my_param_circle_node'),
        ]
    )
