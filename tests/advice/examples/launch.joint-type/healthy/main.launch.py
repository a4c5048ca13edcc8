import os
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, 'bot.urdf'), 'r') as infp:
        robot_desc = infp.read()
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{'robot_description': robot_desc}], arguments=[os.path.join(here, 'bot.urdf')]),
        Node(package='joint_state_publisher', executable='joint_state_publisher'),
    ])
