"""A driver that comes only on request, and a second world for crowds.

    ros2 launch on_request.launch.py drive:=true worlds:=2

There is always the world /one/sim. With drive:=true a node /one/draw_square drives in it. With worlds:=2 there is a second
world, /two/sim.

Grade it: edugrade exercises/on_request.launch.py        A hint: edugrade exercises/on_request.launch.py --hint 1
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import EqualsSubstitution, LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    drive, worlds = LaunchConfiguration('drive'), LaunchConfiguration('worlds')
    return LaunchDescription([
        DeclareLaunchArgument('drive', default_value='false', description='Whether somebody drives.'),
        DeclareLaunchArgument('worlds', default_value='1', choices=['1', '2'], description='How many worlds.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='one'),
        Node(package='turtlesim', executable='draw_square', namespace='one', condition=IfCondition(drive)),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='two',
             condition=IfCondition(EqualsSubstitution(worlds, '2'))),
    ])
