"""One turtle world. The file that includes this one chooses its namespace; config/turtlesim.yaml sets its colours."""
from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare('large_project'), 'config', 'turtlesim.yaml'])
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[config]),
    ])
