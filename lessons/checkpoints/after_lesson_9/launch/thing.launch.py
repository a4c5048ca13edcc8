from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    static = PathJoinSubstitution([FindPackageShare('learning_tf2_py'), 'launch', 'static.launch.py'])
    return LaunchDescription([
        IncludeLaunchDescription(static),
        Node(
            package='tf2_ros', executable='static_transform_publisher', name='thing_publisher',
            arguments=['--x', '1', '--y', '0', '--z', '0', '--yaw', '0', '--pitch', '0', '--roll', '0',
                       '--frame-id', 'tower', '--child-frame-id', 'thing'],
        ),
    ])
