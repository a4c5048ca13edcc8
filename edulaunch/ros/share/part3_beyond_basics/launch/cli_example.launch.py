"""Set the radius of the circle with a launch argument, which is passed on as a parameter."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                'circle_radius', default_value='1.0', description='Sets the desired radius of the circle (in meters).'
            ),
            Node(
                package='part3_beyond_basics',
                executable='param_circle.py',
                name='my_param_circle_node',
                parameters=[{'radius': LaunchConfiguration('circle_radius')}],
            ),
        ]
    )
