from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['ros2', 'run', 'turtlesim', 'turtlesim_node', '--ros-args', '-p', 'background_r:=200'], output='screen'),
    ])
