from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    leader = LaunchConfiguration('leader')
    return LaunchDescription(
        [
            DeclareLaunchArgument('leader', default_value='turtle1'),
            Node(
                package='tf2_ros',
                executable='static_transform_publisher',
                name=['carrot_of_', leader],
                arguments=['--x', '-1', '--frame-id', leader, '--child-frame-id', ['carrot_', leader]],
            ),
        ]
    )
