import os

from launch import LaunchDescription
from launch_ros.actions import Node
from launch.actions import ExecuteProcess, TimerAction

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        TimerAction(period=2.0, actions=[ExecuteProcess(cmd=['ros2', 'service', 'call', '/stop', 'std_srvs/srv/Empty'])]),
        ExecuteProcess(cmd=['python3', os.path.join(HERE, 'walker.py')], output='screen'),
    ])
