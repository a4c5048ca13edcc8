from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    x = LaunchConfiguration('x', default='2.0')
    controller = Node(package='go_to_goal', executable='go', arguments=[x, LaunchConfiguration('y'), '0.1'])
    return LaunchDescription([
        DeclareLaunchArgument('y', default_value='9.0', description='where to go'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        controller,
        RegisterEventHandler(OnProcessExit(target_action=controller, on_exit=[LogInfo(msg=['there: ', x])])),
    ])
