"""A driver that waits for a message, and a launch that ends after some time.

    ros2 launch careful.launch.py end:=5.0

The process echo receives one message of the talker and ends. Only then the driver starts. After end seconds, the launch
shuts down, and everything ends.

Grade it with `edugrade exercises/careful.launch.py`. Add `--hint 1` for a hint.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, RegisterEventHandler, Shutdown, TimerAction
from launch.event_handlers import OnProcessExit
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    end = LaunchConfiguration('end')
    echo = ExecuteProcess(cmd=['ros2', 'topic', 'echo', '/chatter', '--once'])
    driver = Node(package='turtlesim', executable='draw_square', name='driver')
    return LaunchDescription([
        DeclareLaunchArgument('end', default_value='5.0', description='Seconds until everything ends.'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='demo_nodes_py', executable='talker'),
        # TODO 1: when echo has ended, start driver
        # TODO 2: after end seconds, shut everything down
        echo,
    ])
