"""The top-level launch file: two worlds, a follower with its goal, a carrot, and a turtle that copies the follower.

    ros2 launch large_project large_project.launch.py goal:=turtle1

A large launch file can be short if it includes small ones and sets only their differences. Read these first:
world.launch.py, follower.launch.py and mimic.launch.py beside this file, and the parameters of the worlds in
../config/turtlesim.yaml. Then fill the three gaps: two here, and one in the parameter file.

Grade it with `edugrade exercises/large_project`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
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
        # TODO 1: include the world again, in a group that first pushes the namespace turtlesim2

        # TODO 2: pass the launch argument goal to follower.launch.py as its argument target_frame
        include('follower.launch.py'),
        include('mimic.launch.py'),
        Node(package='turtle_tf2_py', executable='fixed_frame_tf2_broadcaster', name='fixed_broadcaster'),
    ])
