from launch import LaunchDescription
from launch.substitutions import EnvironmentVariable
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name=['sim_', EnvironmentVariable('TURTLE_OF_ANA', default_value='one')]),
    ])
