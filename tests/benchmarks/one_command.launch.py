"""One short command, as somebody types it beside a launch."""

from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    """Return the command."""
    return LaunchDescription([ExecuteProcess(cmd=['ros2', 'topic', 'echo', '--once', '/turtle1/pose'])])
