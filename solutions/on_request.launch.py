"""A driver and another world that start only if the user wants them.

    ros2 launch on_request.launch.py drive:=true worlds:=2

The world /one/sim always starts. With drive:=true a node /one/draw_square drives in it. With worlds:=2 another world
starts, /two/sim.

Grade it with `edugrade exercises/on_request.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import EqualsSubstitution, LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    drive, worlds = LaunchConfiguration('drive'), LaunchConfiguration('worlds')
    return LaunchDescription([
        DeclareLaunchArgument('drive', default_value='false', description='true: draw_square drives.'),
        DeclareLaunchArgument('worlds', default_value='1', choices=['1', '2'], description='Number of worlds.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='one'),
        Node(package='turtlesim', executable='draw_square', namespace='one', condition=IfCondition(drive)),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='two',
             condition=IfCondition(EqualsSubstitution(worlds, '2'))),
    ])
