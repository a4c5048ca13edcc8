from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='sleepers', executable=e)
                              for e in ('talker', 'slow', 'answerer', 'early_request')])
