"""One sea; the launch argument blue sets its blue value. The file that includes this one chooses its namespace."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('two_seas'), 'config', 'sea.yaml'])
    return LaunchDescription([
        DeclareLaunchArgument('blue', default_value='90', description='0 to 255.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim',
             parameters=[config, {'background_b': LaunchConfiguration('blue')}]),
    ])
