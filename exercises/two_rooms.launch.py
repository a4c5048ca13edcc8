"""A talker and a listener in the hall, and a listener in the kitchen that receives the same messages.

    ros2 launch two_rooms.launch.py room:=kitchen

The talker /hall/talker publishes on /hall/chatter, and /hall/listener receives its messages. The launch argument room is
the namespace of the second listener, so its name is known only at launch. It should receive the same messages.

Grade it with `edugrade exercises/two_rooms.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    room = LaunchConfiguration('room')
    return LaunchDescription([
        DeclareLaunchArgument('room', default_value='kitchen', description='Namespace of the second listener.'),
        Node(package='demo_nodes_py', executable='talker', namespace='hall'),
        # TODO 1: start the listener of demo_nodes_py in the namespace hall

        # TODO 2: start a listener in the namespace room, and remap its chatter to /hall/chatter

    ])
