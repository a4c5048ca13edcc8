"""The commands `ros2` and `rosdep`. Where a real ROS 2 is sourced they step aside: nothing of it is ever shadowed."""

from __future__ import annotations

import os
import sys

LOOKED_AT = 2048


def ros2() -> int:
    """The command `ros2`: the real one where a real ROS 2 is sourced, else that of the simulated machine. Returns the exit code."""
    words = sys.argv[1:]
    loudly = words[:1] == ['--verbose']
    _step_aside('ros2', words, loudly)
    from edulaunch.machine.client import run

    if loudly:
        sys.stderr.write('edulaunch: no real ROS 2 is sourced here, this is the simulated machine\n')
    return run(['ros2', *words[loudly:]])


def rosdep() -> int:
    """The command `rosdep`: the real one where there is one, else `edulaunch rosdep`."""
    words = sys.argv[1:]
    _step_aside('rosdep', words, words[:1] == ['--verbose'])
    from edulaunch.cli.main import main

    return main(['rosdep', *words])


def _step_aside(name: str, words: list[str], loudly: bool) -> None:
    """Become the real command, if there is one: that does not return."""
    if name == 'ros2' and not (os.environ.get('ROS_DISTRO') or os.environ.get('AMENT_PREFIX_PATH')):
        return
    real = real_command(name)
    if real is None:
        return
    if loudly or '--verbose' in words:
        sys.stderr.write(f'edulaunch: a real ROS 2 is sourced, stepping aside for {real} (`edulaunch {name}` is ours)\n')
    os.execv(real, [real, *words[loudly:]])


def real_command(name: str) -> str | None:
    """The first command of that name on the PATH that is not one of edulaunch's."""
    for place in os.environ.get('PATH', '').split(os.pathsep):
        path = os.path.join(place, name)
        if os.path.isfile(path) and os.access(path, os.X_OK):
            with open(path, 'rb') as file:
                if b'edulaunch' not in file.read(LOOKED_AT):
                    return path
    return None
