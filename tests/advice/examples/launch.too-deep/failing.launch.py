from launch import LaunchDescription
from launch.actions import LogInfo


def nodes(count):
    return nodes(count - 1) + [LogInfo(msg=str(count))]


def generate_launch_description():
    return LaunchDescription(nodes(3))
