"""A talker and a listener in the hall, and a listener in the kitchen that hears the same news.

    ros2 launch two_rooms.launch.py room:=kitchen

The talker /hall/talker speaks on /hall/chatter, and /hall/listener hears it. The second listener lives in a namespace
of which only the name is known when the file is launched: the launch argument room. It shall hear the talker of the hall, too.

Grade it: edugrade exercises/two_rooms.launch.py        A hint: edugrade exercises/two_rooms.launch.py --hint 1
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    room = LaunchConfiguration('room')
    return LaunchDescription([
        DeclareLaunchArgument('room', default_value='kitchen', description='Where the second listener lives.'),
        Node(package='demo_nodes_py', executable='talker', namespace='hall'),
        # TODO 1: the listener of demo_nodes_py in the namespace hall

        # TODO 2: a listener in the namespace room, whose chatter is /hall/chatter

    ])
