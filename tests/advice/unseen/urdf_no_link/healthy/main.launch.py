from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(
                package='robot_state_publisher',
                executable='robot_state_publisher',
                parameters=[
                    {
                        'robot_description': '<robot name="cart"><link name="base"/><link name="mast"/><joint name="j" type="fixed"><parent link="base"/><child link="mast"/></joint></robot>'
                    }
                ],
            )
        ]
    )
