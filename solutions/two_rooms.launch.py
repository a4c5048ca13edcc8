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
        Node(package='demo_nodes_py', executable='listener', namespace='hall'),
        Node(package='demo_nodes_py', executable='listener', namespace=room, remappings=[('chatter', '/hall/chatter')]),
    ])
