"""The commands as a shell starts them."""

from __future__ import annotations

from edulaunch.runtime.quiet_start import run_quietly


def edulaunch() -> int:
    """Run the command `edulaunch`, and return its exit code."""
    return run_quietly('edulaunch.desk.cli.main', 'main')


def ros2() -> int:
    """Run the command `ros2`, and return its exit code."""
    return run_quietly('edulaunch.desk.machine.command', 'ros2')


def rosdep() -> int:
    """Run the command `rosdep`, and return its exit code."""
    return run_quietly('edulaunch.desk.cli.rosdep', 'command')
