from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    names = ['hasty', 'misspelt', 'other_type', 'two_nodes', 'waits_for_listener']
    nodes = [Node(package='nobody_there', executable=name) for name in names]
    sim = Node(package='turtlesim', executable='turtlesim_node')
    return LaunchDescription(nodes + [TimerAction(period=2.0, actions=[sim])])
