import os
from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction


def generate_launch_description():
    here = os.path.dirname(__file__)
    def go(name, at):
        return TimerAction(period=at, actions=[ExecuteProcess(cmd=['ros2', 'lifecycle', 'set', '/talker', name])])
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', os.path.join(here, 'd.py')], output='screen'),
        ExecuteProcess(cmd=['ros2', 'topic', 'echo', '/chatter', 'std_msgs/msg/String'], output='screen'),
        go('configure', 1.0), go('activate', 2.0),
    ])
