"""The functions that the installed commands `edulaunch`, `ros2` and `rosdep` call."""

from __future__ import annotations

import os
import sys


def edulaunch() -> int:
    """Run the command `edulaunch`, and return its exit code.

    `edulaunch launch` first restarts Python with a fixed hash seed, so that a set of strings has the same order in every run.
    """
    if sys.argv[1:2] == ['launch'] and 'PYTHONHASHSEED' not in os.environ and sys.platform not in ('win32', 'emscripten'):
        os.environ['PYTHONHASHSEED'] = '0'
        os.execv(sys.executable, [sys.executable, *sys.orig_argv[1:]])
    return _run('edulaunch.desk.cli.main', 'main')


def ros2() -> int:
    """Run the command `ros2`, and return its exit code."""
    return _run('edulaunch.desk.machine.command', 'ros2')


def rosdep() -> int:
    """Run the command `rosdep`, and return its exit code."""
    return _run('edulaunch.desk.cli.rosdep', 'command')


def _run(module: str, name: str) -> int:
    """Run a command, and return its exit code.

    The imports are inside this function, so that Python does not load the modules twice when it restarts.
    """
    from edulaunch.runtime.quiet_start import run_quietly

    return run_quietly(module, name)
