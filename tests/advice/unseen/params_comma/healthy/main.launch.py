from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'),
        Node(package='robo', executable='driver', name='driver', output='screen', parameters=[PathJoinSubstitution([FindPackageShare('robo'), 'config', 'robo.yaml'])]),
    ])
