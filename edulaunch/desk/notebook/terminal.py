"""The terminal of a notebook, which runs the lines of its cells on one simulated machine."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from edulaunch.advice.workspace.not_needed import WINDOWS, answer
from edulaunch.desk.notebook.line import QUIET, read_line
from edulaunch.desk.notebook.machine import NotebookMachine
from edulaunch.engine.packages.discovery import find_workspaces
from edulaunch.engine.recording import Recording
from edulaunch.engine.sim.loops import outer_loop_set_aside
from edulaunch.errors import UnusableInput

ONLY_SHOWS = {'-h', '--help', '-s', '--show-args', '--show-arguments', '-p', '--print', '--print-description'}
"""With one of these options, `ros2 launch` starts nothing."""
LISTS = (['node', 'list'], ['topic', 'list'], ['service', 'list'], ['param', 'list'], ['action', 'list'])
"""Commands that print nothing if no program runs, as in ROS 2."""
NOTHING_RUNS = 'note: no program runs yet; start one with %ros2 launch PACKAGE FILE, or %ros2 run PACKAGE EXECUTABLE &\n'
SAID_ALWAYS = ('warning:', 'error:', 'note:')
"""The beginnings of the lines that `--quiet` does not hide."""


class CellTerminal:
    """Reads the lines of cells, and runs them on the notebook's machine.

    :param write: a function that receives all output, as write(stream, text).
    """

    def __init__(self, write: Callable[[str, str], object]) -> None:
        self._show = write
        self._is_quiet = False
        self.machine = NotebookMachine(self._write, self.workspaces)
        self._sourced: list[str] = []

    def ros2(self, text: str) -> Any:
        """Run the words after `ros2`. A launch returns its Recording, and `view` returns the live view.

        :raises UnusableInput: when the launch file is missing, or the words cannot be parsed.
        :raises LaunchFileError: when the launch file contains a mistake. The message names the student's file and line.
        """
        line = read_line(text)
        self._is_quiet = line.quiet
        if line.words[:1] == ['view']:
            return self.view(line.words[1:])
        if line.words[:1] == ['run'] and line.words[1:2] and line.words[1] in WINDOWS and self.machine.session is not None:
            return self.view([WINDOWS[line.words[1]]])
        if self.machine.session is None and line.words[:2] in LISTS:
            self._write('stderr', NOTHING_RUNS)
        with self.machine.hosting.cell(), outer_loop_set_aside():
            if line.words[:1] in (['jobs'], ['stop'], ['wait']):
                self.machine.own_word(*line.words)
            elif line.words[:1] != ['launch'] or ONLY_SHOWS & set(line.words) or line.shell:
                self.machine.command(line)
            else:
                return self.machine.launch(line)
        return None

    def several(self, first: str, cell: str) -> Any:
        """Run the lines of a cell in order, and return the last Recording. Skip empty lines and lines that begin with `#`.

        :param first: the words after `%%ros2`, which are a command, or `--quiet` for all launches and runs of the cell.
        :param cell: the other lines of the cell.
        """
        quiet = first.split() == [QUIET]
        lines = ['' if quiet else first, *cell.split('\n')]
        found = None
        for text in lines:
            if text.strip() and not text.lstrip().startswith('#'):
                result = self.ros2(f'{text} {QUIET}' if quiet and text.split()[0] in ('launch', 'run') else text)
                found = found if result is None else result
        return found

    def _write(self, stream: str, text: str) -> None:
        if not self._is_quiet or text.startswith(SAID_ALWAYS):
            self._show(stream, text)

    def view(self, words: list[str]) -> Any:
        """Return the live view of the machine. Simulated time passes while the live view is visible.

        :param words: the name of the tab to show first, or no word for the tab 'graph'.
        :raises UnusableInput: when no program has run yet, or there is no such tab.
        """
        from edulaunch.desk.machine.started import desk_widget

        if self.machine.session is None:
            raise UnusableInput('nothing has run yet', help='start a launch file: %ros2 launch PACKAGE FILE')
        with self.machine.hosting.cell():
            self.machine.hosting.serve(self.machine.session)
        return desk_widget(self.machine.hosting, words[0] if words else 'graph')

    def source(self, path: str) -> None:
        """Use the packages of a workspace from the next launch on.

        :param path: a workspace, its `install` folder, a setup file in this folder, or a package.
        :raises UnusableInput: when there is no such folder.
        """
        if path.startswith('/opt/ros/'):
            self.set_up(f'source {path}')
            return
        folder = os.path.dirname(path) if os.path.basename(path).startswith(('setup.', 'local_setup.')) else path
        if os.path.basename(folder.rstrip('/')) == 'install' and not os.path.isdir(folder):
            folder = os.path.dirname(folder.rstrip('/'))  # use the workspace itself, because no build is needed
        if not os.path.isdir(folder or '.'):
            raise UnusableInput(
                f'{path!r}: there is no such workspace', help='name a folder with packages, such as %source my_ws'
            )
        self._sourced.append(os.path.abspath(folder or '.'))

    def set_up(self, line: str) -> None:
        """Explain which parts of a command that sets up a ROS 2 computer are not needed here.

        :raises UnusableInput: for any other command.
        """
        text = answer(line.split())
        if text is None:
            raise UnusableInput(f'{line!r} is not a set-up command of ROS 2', help=f'run it on your own computer with !{line}')
        self._write('stdout', f'{text}\n')

    def recording(self) -> Recording:
        """Return the recording of the machine until now.

        :raises UnusableInput: when no program has run yet.
        """
        if self.machine.session is None:
            raise UnusableInput('nothing has run yet', help='start a launch file: %ros2 launch PACKAGE FILE')
        return self.machine.session.snapshot()

    def workspaces(self) -> list[str]:
        """Return the packages that the user has sourced, or the workspaces that are found from the folder of the notebook."""
        return self._sourced or find_workspaces(os.getcwd(), os.environ)
