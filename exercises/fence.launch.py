"""Two worlds, one dark and one bright. At the moment the settings of the dark one also apply to the other.

    ros2 launch fence.launch.py

There should be /night/sim with dark water (background_b 40) and /day/sim with the default (255). Instead there is
/night/day/sim, and its water is dark, too. Limit the settings to the group.

Grade it with `edugrade exercises/fence.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushROSNamespace, SetParameter

WORLD = {'package': 'turtlesim', 'executable': 'turtlesim_node', 'name': 'sim'}


def generate_launch_description():
    blue = LaunchConfiguration('blue')
    return LaunchDescription([
        DeclareLaunchArgument('blue', default_value='40', description='Blue value of the night.'),
        # TODO 1: the settings inside this group must not apply outside of it
        GroupAction(scoped=False, actions=[
            PushROSNamespace('night'),
            SetParameter('background_b', blue),
            Node(**WORLD),
        ]),
        Node(**WORLD, namespace='day'),
    ])
