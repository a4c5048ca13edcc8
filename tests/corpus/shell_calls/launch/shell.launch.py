from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='turtlesim'),
        Node(package='shell_calls', executable='caller', output='screen'),
        TimerAction(period=0.5, actions=[
            ExecuteProcess(cmd=['ros2 topic list > /dev/null && echo listed; ros2 node list'], shell=True, output='screen', name='line')]),
    ])
