"""turtle2 follows turtle1 with the help of tf2.

    ros2 launch follow.launch.py move:=true

broadcaster1 broadcasts where turtle1 is: the frame turtle1 relative to the frame world. The node turtle_tf2_listener
spawns turtle2, asks tf2 once a second where the frame `target_frame` is as seen from the frame turtle2, and
drives turtle2 there. It needs both frames. Fill the two gaps.

The grader launches this file twice: without arguments, when turtle1 does not move, and with move:=true, when
turtle1 drives a square. The part for the square is complete.

Grade it with `edugrade exercises/follow.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    move = LaunchConfiguration('move')
    return LaunchDescription([
        DeclareLaunchArgument('move', default_value='false', description='true: turtle1 drives a square.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='turtlesim', executable='draw_square', condition=IfCondition(move)),
        Node(
            package='turtle_tf2_py',
            executable='turtle_tf2_broadcaster',
            name='broadcaster1',
            parameters=[{'turtlename': 'turtle1'}],
        ),
        # TODO 1: start turtle_tf2_listener of turtle_tf2_py, with the parameter target_frame set to turtle1

        # TODO 2: start a node like broadcaster1 for turtle2, named broadcaster2

    ])
