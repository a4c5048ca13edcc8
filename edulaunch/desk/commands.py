"""The commands as a shell starts them: Ctrl-C while their modules load ends them without a traceback."""

from __future__ import annotations

import signal
from collections.abc import Callable
from importlib import import_module

INTERRUPTED = 130


def edulaunch() -> int:
    """The command `edulaunch`; returns its exit code."""
    return run_quietly('edulaunch.desk.cli.main', 'main')


def ros2() -> int:
    """The command `ros2`; returns its exit code."""
    return run_quietly('edulaunch.desk.machine.command', 'ros2')


def rosdep() -> int:
    """The command `rosdep`; returns its exit code."""
    return run_quietly('edulaunch.desk.cli.rosdep', 'command')


def run_quietly(module: str, name: str) -> int:
    """Load a command and run it. While it loads, Ctrl-C ends the process at once and without a traceback."""
    before = signal.getsignal(signal.SIGINT)
    if before is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    command: Callable[[], int] = getattr(import_module(module), name)
    try:
        if before is signal.default_int_handler:
            signal.signal(signal.SIGINT, before)
        return command()
    except KeyboardInterrupt:
        return INTERRUPTED
