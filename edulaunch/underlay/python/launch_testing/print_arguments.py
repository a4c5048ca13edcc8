"""Showing the arguments of a launch test."""

from __future__ import annotations

from launch.launch_description import LaunchDescription

from edulaunch.processes.current import current_process


def print_arguments_of_launch_description(*, launch_description: LaunchDescription) -> None:
    """Print the launch arguments of a description, as `launch_test --show-args` does."""
    from ros2launch.api.api import arguments_text

    current_process().stdout.write(arguments_text(launch_description) + '\n')
