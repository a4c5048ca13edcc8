"""Two worlds, and the dark one infects the bright one: something leaks.

    ros2 launch fence.launch.py

There should be /night/sim with dark water (background_b 40) and /day/sim with the usual one (255). There is a
/night/day/sim instead, and it is dark, too. Close the fence.

Grade it: edugrade exercises/fence.launch.py        A hint: edugrade exercises/fence.launch.py --hint 1
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushROSNamespace, SetParameter

WORLD = {'package': 'turtlesim', 'executable': 'turtlesim_node', 'name': 'sim'}


def generate_launch_description():
    blue = LaunchConfiguration('blue')
    return LaunchDescription([
        DeclareLaunchArgument('blue', default_value='40', description='How blue the night is.'),
        # TODO 1: nothing that is set in here may get out
        GroupAction(scoped=False, actions=[
            PushROSNamespace('night'),
            SetParameter('background_b', blue),
            Node(**WORLD),
        ]),
        Node(**WORLD, namespace='day'),
    ])
