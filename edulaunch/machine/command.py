"""The command `ros2`. Where a real ROS 2 is sourced it steps aside: nothing of that is ever shadowed."""

from __future__ import annotations

import os
import sys

LOOKED_AT = 2048


def ros2() -> int:
    """The command `ros2`: the real one where a real ROS 2 is sourced, else the simulated machine's; returns the exit code."""
    words = sys.argv[1:]
    loudly = words[:1] == ['--verbose']
    step_aside('ros2', words, loudly)
    from edulaunch.machine.page_beside import run

    if loudly:
        sys.stderr.write('edulaunch: no real ROS 2 is sourced here, this is the simulated machine\n')
    return run(words[loudly:])


def step_aside(name: str, words: list[str], loudly: bool) -> None:
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
