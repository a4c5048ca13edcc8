"""The command `ros2`, with the live page beside it where it is asked for (`ros2 launch ... --view`, `ros2 run rviz2 rviz2`).

Where a real ROS 2 is sourced it steps aside: nothing of that is ever shadowed.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

LOOKED_AT = 2048
VIEW = '--view'
SHOW = [sys.executable, '-m', 'edulaunch', 'view']


def ros2() -> int:
    """The command `ros2`: the real one where a real ROS 2 is sourced, else the simulated machine's; returns the exit code."""
    words = sys.argv[1:]
    loudly = words[:1] == ['--verbose']
    step_aside('ros2', words, loudly)
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


def run(words: Sequence[str]) -> int:
    """Run `ros2 WORDS...` on the machine, with the page beside it if that is asked for; returns the exit code.

    The page is there for as long as the command runs; of a tool that is nothing but a window here, until Ctrl-C.
    """
    from edulaunch.desk.machine import client

    tab = tab_of(words)
    if tab is None:
        return client.run(['ros2', *words])
    if words[0] == 'run' and words[1] != 'rviz2':
        os.execv(SHOW[0], [*SHOW, '--tab', tab])
    import subprocess

    page = subprocess.Popen(
        [*SHOW, '--tab', tab, '--until-eof'], stdin=subprocess.PIPE, start_new_session=True
    )  # Ctrl-C is the command's
    try:
        return client.run(['ros2', *(word for word in words if word != VIEW)])
    finally:
        assert page.stdin is not None
        page.stdin.close()  # as it is when this process is killed
        page.wait()


def tab_of(words: Sequence[str]) -> str | None:
    """Which tab the command wants to see; None for one that wants none. A window is opened only where a person sits."""
    if words[:1] == ['launch'] and VIEW in words:
        return 'graph'
    if words[:1] == ['run'] and len(words) > 1 and words[1].startswith(('rqt', 'rviz')) and os.isatty(1):
        from edulaunch.advice.workspace.not_needed import WINDOWS

        return WINDOWS.get(words[1])
    return None
