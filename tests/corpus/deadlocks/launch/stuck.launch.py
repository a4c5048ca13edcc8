from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    stuck = [Node(package='deadlocks', executable=name)
             for name in ('nested_spin', 'sync_call', 'busy_wait', 'rate_in_timer', 'await_in_group',
                          'nested_once', 'healthy')]
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node')] + stuck)
