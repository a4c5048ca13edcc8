"""turtle2 follows the frame `target_frame`. You can drive turtle1."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def broadcaster(number):
    return Node(
        package='turtle_tf2_py',
        executable='turtle_tf2_broadcaster',
        name=f'broadcaster{number}',
        parameters=[{'turtlename': f'turtle{number}'}],
    )


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument('target_frame', default_value='turtle1', description='Target frame name.'),
            Node(package='turtlesim', executable='turtlesim_node', name='sim'),
            broadcaster(1),
            broadcaster(2),
            Node(
                package='turtle_tf2_py',
                executable='turtle_tf2_listener',
                name='listener',
                parameters=[{'target_frame': LaunchConfiguration('target_frame')}],
            ),
        ]
    )
