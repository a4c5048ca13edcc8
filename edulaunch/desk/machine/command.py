"""The command `ros2`. With `ros2 launch ... --view` or `ros2 run rviz2 rviz2`, it also opens the live view.

If a real ROS 2 is sourced, this command runs the real `ros2` instead.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

LOOKED_AT = 2048
VIEW = '--view'
SHOW = [sys.executable, '-m', 'edulaunch', 'view']


def ros2() -> int:
    """Run the real `ros2` if a real ROS 2 is sourced, otherwise `ros2` on the simulated machine. Return the exit code."""
    words = sys.argv[1:]
    loudly = words[:1] == ['--verbose']
    step_aside('ros2', words, loudly)
    if loudly:
        sys.stderr.write('edulaunch: no real ROS 2 is sourced here, so this command runs on the simulated machine\n')
    return run(words[loudly:])


def step_aside(name: str, words: list[str], loudly: bool) -> None:
    """Replace this process by the real command if there is one. In that case, this call does not return.

    :param name: the name of the command.
    :param words: the arguments of the command.
    :param loudly: whether to print that the real command runs.
    """
    if name == 'ros2' and not (os.environ.get('ROS_DISTRO') or os.environ.get('AMENT_PREFIX_PATH')):
        return
    real = real_command(name)
    if real is None:
        return
    if loudly or '--verbose' in words:
        sys.stderr.write(f'edulaunch: a real ROS 2 is sourced, so {real} runs (`edulaunch {name}` runs the simulation)\n')
    os.execv(real, [real, *words[loudly:]])


def real_command(name: str) -> str | None:
    """Return the path of the first command with this name on PATH that does not belong to edulaunch. Return None if there is no
    such command.
    """
    for place in os.environ.get('PATH', '').split(os.pathsep):
        path = os.path.join(place, name)
        if os.path.isfile(path) and os.access(path, os.X_OK):
            with open(path, 'rb') as file:
                if b'edulaunch' not in file.read(LOOKED_AT):
                    return path
    return None


def run(words: Sequence[str]) -> int:
    """Run `ros2 WORDS...` on the machine, and open the live view if the command asks for it. Return the exit code.

    The page exists while the command runs. For a tool that only opens a window, the page exists until Ctrl-C.
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
    )  # so that Ctrl-C reaches only the command
    try:
        return client.run(['ros2', *(word for word in words if word != VIEW)])
    finally:
        assert page.stdin is not None
        page.stdin.close()  # if this process is killed, the system closes the pipe
        page.wait()


def tab_of(words: Sequence[str]) -> str | None:
    """Return the tab of the live view that the command needs, or None if it needs no live view.

    A tool such as rqt_graph opens the live view only if its output is a terminal.
    """
    if words[:1] == ['launch'] and VIEW in words:
        return 'graph'
    if words[:1] == ['run'] and len(words) > 1 and words[1].startswith(('rqt', 'rviz')) and os.isatty(1):
        from edulaunch.advice.workspace.not_needed import WINDOWS

        return WINDOWS.get(words[1])
    return None
