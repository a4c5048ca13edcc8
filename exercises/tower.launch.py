"""Three frames, one on top of the other: floor, table, lamp.

    ros2 launch tower.launch.py height:=0.75

The frame table is at x = 1.0 in the frame floor, and the launch argument height is its z. The frame lamp is 0.4 m above
the frame table, and turned by a quarter turn to the left (yaw 1.5708).

Grade it with `edugrade exercises/tower.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def frame(parent, child, *arguments):
    return Node(package='tf2_ros', executable='static_transform_publisher', name=f'{child}_frame',
                arguments=[*arguments, '--frame-id', parent, '--child-frame-id', child])


def generate_launch_description():
    height = LaunchConfiguration('height')
    return LaunchDescription([
        DeclareLaunchArgument('height', default_value='0.75', description='Height of the table, in metres.'),
        frame('house', 'floor'),
        # TODO 1: publish table relative to floor

        # TODO 2: publish lamp relative to table

    ])
