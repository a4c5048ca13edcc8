"""A simulator whose water takes its colour from three launch arguments.

    ros2 launch water.launch.py red:=200 green:=0 blue:=40

turtlesim_node has the parameters background_r, background_g and background_b, whole numbers from 0 to 255.

Grade it with `edugrade exercises/water.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('red', default_value='69', description='Red value, 0 to 255.'),
        DeclareLaunchArgument('green', default_value='86', description='Red value, 0 to 255.'),
        DeclareLaunchArgument('blue', default_value='255', description='Red value, 0 to 255.'),
        Node(
            package='turtlesim', executable='turtlesim_node', name='sim',
            parameters=[{f'background_{colour[0]}': LaunchConfiguration(colour) for colour in ('red', 'green', 'blue')}],
        ),
    ])
