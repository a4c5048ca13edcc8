"""The live page beside a command in a terminal: `ros2 launch ... --view`, and the tools that open a window in ROS 2."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence

VIEW = '--view'
SHOW = [sys.executable, '-m', 'edulaunch', 'view']


def run(words: Sequence[str]) -> int:
    """Run `ros2 WORDS...` on the machine, with the page beside it if that is asked for; returns the exit code.

    The page is there for as long as the command runs; of a tool that is nothing but a window here, until Ctrl-C.
    """
    from edulaunch.machine import client

    tab = tab_of(words)
    if tab is None:
        return client.run(['ros2', *words])
    if words[0] == 'run' and words[1] != 'rviz2':
        os.execv(SHOW[0], [*SHOW, '--tab', tab])
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
        from edulaunch.workspace.not_needed import WINDOWS

        return WINDOWS.get(words[1])
    return None
