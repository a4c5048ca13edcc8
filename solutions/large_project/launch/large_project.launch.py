"""The top-level launch file: two worlds, a follower with its goal, a carrot, and a turtle that copies the follower.

    ros2 launch large_project large_project.launch.py goal:=turtle1

A large launch file can be short if it includes small ones and sets only their differences. Read these first:
world.launch.py, follower.launch.py and mimic.launch.py beside this file, and the parameters of the worlds in
../config/turtlesim.yaml. Then fill the three gaps: two here, and one in the parameter file.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node, PushRosNamespace
from launch_ros.substitutions import FindPackageShare


def include(name, **arguments):
    """Include a launch file of this package, with values for its arguments."""
    path = PathJoinSubstitution([FindPackageShare('large_project'), 'launch', name])
    return IncludeLaunchDescription(PythonLaunchDescriptionSource(path), launch_arguments=arguments.items())


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument(
            'goal',
            default_value='carrot1',
            description='The frame that turtle2 drives to: carrot1 or turtle1.',
        ),
        include('world.launch.py'),
        GroupAction([
            PushRosNamespace('turtlesim2'),
            include('world.launch.py'),
        ]),
        include('follower.launch.py', target_frame=LaunchConfiguration('goal')),
        include('mimic.launch.py'),
        Node(package='turtle_tf2_py', executable='fixed_frame_tf2_broadcaster', name='fixed_broadcaster'),
    ])
