"""The commands as a shell starts them."""

from __future__ import annotations

from edulaunch.runtime.quiet_start import run_quietly


def edulaunch() -> int:
    """The command `edulaunch`; returns its exit code."""
    return run_quietly('edulaunch.desk.cli.main', 'main')


def ros2() -> int:
    """The command `ros2`; returns its exit code."""
    return run_quietly('edulaunch.desk.machine.command', 'ros2')


def rosdep() -> int:
    """The command `rosdep`; returns its exit code."""
    return run_quietly('edulaunch.desk.cli.rosdep', 'command')
