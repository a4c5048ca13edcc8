"""A robot that drives a circle, and its world, in one launch file.

    ros2 launch circle.launch.py circle_radius:=0.8

The node param_circle.py of the package part3_beyond_basics publishes velocities for a circle. Its parameter
`radius` is the radius in metres; the default is 0.5. No robot receives the velocities yet, and the user
cannot choose the radius. Fill the three gaps.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument(
            'circle_radius',
            description='Sets the desired radius of the circle (in meters).',
            default_value='1.0',
        ),
        IncludeLaunchDescription(
            PythonLaunchDescriptionSource(
                PathJoinSubstitution([
                    FindPackageShare('turtlebot3_gazebo'), 'launch', 'empty_world.launch.py',
                ])
            )
        ),
        Node(
            package='part3_beyond_basics',
            executable='param_circle.py',
            name='my_param_circle_node',
            parameters=[{'radius': LaunchConfiguration('circle_radius')}],
        ),
    ])
