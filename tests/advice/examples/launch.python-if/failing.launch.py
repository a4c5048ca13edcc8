from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    gui = LaunchConfiguration('gui')
    nodes = [Node(package='turtlesim', executable='turtlesim_node')]
    if gui == 'true':
        nodes.append(Node(package='turtlesim', executable='draw_square'))
    return LaunchDescription([DeclareLaunchArgument('gui', default_value='true'), *nodes])
