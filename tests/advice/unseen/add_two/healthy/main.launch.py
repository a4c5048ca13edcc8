from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    description = LaunchDescription()
    sim = Node(package='turtlesim', executable='turtlesim_node')
    mimic = Node(
        package='turtlesim', executable='mimic', remappings=[('input/pose', 'turtle1/pose'), ('output/cmd_vel', 'other/cmd_vel')]
    )
    description.add_action(sim)
    description.add_action(mimic)
    description.add_action(Node(package='turtlesim', executable='turtlesim_node', name='other', remappings=[('turtle1/cmd_vel', 'other/cmd_vel'), ('turtle1/pose', 'other/pose')]))
    return description
