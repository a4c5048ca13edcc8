from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_py', executable='listener', remappings=[('chatter', 'news')]),
        ExecuteProcess(cmd=['ros2', 'run', 'demo_nodes_py', 'talker', '--ros-args', '-r', 'chatter:=news'], output='screen'),
    ])
