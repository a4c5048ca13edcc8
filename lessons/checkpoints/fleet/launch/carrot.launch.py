from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    leader, behind = LaunchConfiguration('leader'), LaunchConfiguration('behind')
    return LaunchDescription([
        DeclareLaunchArgument('leader', default_value='turtle1', description='The frame in front of the carrot.'),
        DeclareLaunchArgument('behind', default_value='1.0', description='Distance in metres.'),
        Node(package='tf2_ros', executable='static_transform_publisher', name=['carrot_of_', leader],
             arguments=['--x', ['-', behind], '--frame-id', leader, '--child-frame-id', ['carrot_', leader]]),
    ])
