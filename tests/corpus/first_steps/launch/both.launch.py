from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    ld = LaunchDescription()
    listener = Node(package='first_steps', executable='hear')
    talker = Node(package='first_steps', executable='say', output='screen')
    ld.add_action(listener)
    ld.add_action(talker)
    return ld
