"""A terminal on a simulated machine that outlives its commands."""

from __future__ import annotations

import os
import shlex
import signal
from collections.abc import Callable

from edulaunch.cli.launch import split_words
from edulaunch.errors import UnusableInput
from edulaunch.machine.outer_loop import outer_loop_set_aside
from edulaunch.machine.snapshot import snapshot
from edulaunch.packages.discovery import find_workspaces
from edulaunch.processes.spec import ProcessSpec
from edulaunch.recording import Recording
from edulaunch.session import Session
from edulaunch.workspace.not_needed import answer

LAUNCH_S = 20.0
COMMAND_S = {'topic echo': 1.0}
OTHER_S = 5.0
"""Simulated seconds after which Ctrl-C is pressed, unless `--for` says it: for a launch, for what says a lot, for others."""
ONLY_SHOWS = {'-h', '--help', '-s', '--show-args', '--show-arguments', '-p', '--print', '--print-description'}
"""With one of these `ros2 launch` starts nothing."""
PATIENCE_S = 15.0
"""Simulated seconds that a program has to end after Ctrl-C."""


class Terminal:
    """Runs `ros2` command lines. `launch` starts a new machine; every other command runs beside what still runs on it.

    :param write: called as write(stream, text) with everything that is printed.
    """

    def __init__(self, write: Callable[[str, str], object]) -> None:
        self._write = write
        self._session: Session | None = None
        self._sourced: list[str] = []

    def ros2(self, line: str) -> Recording | None:
        """Run the words behind `ros2`. A launch returns its Recording.

        :raises UnusableInput: for a launch file that is not there, or words that cannot be read.
        :raises LaunchFileError: for a launch file with a mistake; names the student's file and line.
        """
        try:
            words = shlex.split(line)
        except ValueError as error:
            raise UnusableInput(f'cannot read this command: {error}', help='a quotation mark is missing its partner') from None
        seconds, seed = _take_number(words, '--for'), _take_number(words, '--seed')
        with outer_loop_set_aside():
            if words[:1] == ['launch'] and not ONLY_SHOWS & set(words):
                return self._launch(words[1:], LAUNCH_S if seconds is None else seconds, int(seed or 0))
            self._command(words, seconds)
        return None

    def source(self, path: str) -> None:
        """Use the packages of a workspace from the next launch on.

        :param path: a workspace, its `install` folder, a setup file in that, or a package.
        :raises UnusableInput: when there is no such folder.
        """
        if path.startswith('/opt/ros/'):
            self.set_up(f'source {path}')
            return
        folder = os.path.dirname(path) if os.path.basename(path).startswith(('setup.', 'local_setup.')) else path
        if os.path.basename(folder.rstrip('/')) == 'install' and not os.path.isdir(folder):
            folder = os.path.dirname(folder.rstrip('/'))  # nothing has to be built here
        if not os.path.isdir(folder or '.'):
            raise UnusableInput(
                f'{path!r}: there is no such workspace', help='%source takes a folder with packages, such as my_ws'
            )
        self._sourced.append(os.path.abspath(folder or '.'))

    def set_up(self, line: str) -> None:
        """Answer a command that sets up a real ROS 2 machine: a sentence about what is not needed here.

        :raises UnusableInput: for another command.
        """
        said = answer(line.split())
        if said is None:
            raise UnusableInput(f'{line!r} sets up nothing of ROS 2', help=f'for a command of your own machine: !{line}')
        self._write('stdout', f'{said}\n')

    def recording(self) -> Recording:
        """What happened on the machine until now.

        :raises UnusableInput: when nothing was started yet.
        """
        if self._session is None:
            raise UnusableInput('nothing has run yet', help='start something: %ros2 launch PACKAGE FILE')
        return snapshot(self._session)

    def workspaces(self) -> list[str]:
        """What was sourced; else what is found from the folder of the notebook."""
        return self._sourced or find_workspaces(os.getcwd(), os.environ)

    def _new_session(self, seed: int) -> Session:
        if self._session is not None:
            self._session.close()
        self._session = Session(seed=seed, workspaces=self.workspaces(), console=self._write)
        return self._session

    def _launch(self, words: list[str], seconds: float, seed: int) -> Recording:
        if not words:
            raise UnusableInput('launch what?', help='%ros2 launch PACKAGE FILE name:=value --for SECONDS')
        session = self._new_session(seed)
        launch = session.launch(*split_words(words[0], words[1:]))
        session.run(seconds)
        launch.raise_error()
        found = snapshot(session)
        for line in found.warnings:
            self._write('stderr', f'warning: {line}\n')
        return found

    def _command(self, words: list[str], seconds: float | None) -> None:
        """Run a command to its end, or press Ctrl-C when its time is up."""
        session = self._session or self._new_session(0)
        stays = words[-1:] == ['&']
        spec = ProcessSpec(argv=('ros2', *(words[:-1] if stays else words)), name='ros2', cwd=os.getcwd())
        process = session.host.start(spec, on_output=self._write, on_exit=None if stays else lambda code: session.sim.stop())
        if stays:
            self._write('stdout', f'[{process.pid}]\n')
            return
        interrupted = session.run(COMMAND_S.get(' '.join(words[:2]), OTHER_S) if seconds is None else seconds)
        if process.returncode is None:
            if interrupted:
                self._write('stdout', '^C\n')
            elif seconds is None:
                self._write(
                    'stdout', f'^C (pressed for you at t = {session.sim.elapsed_s:.2f} s; say how long with --for SECONDS)\n'
                )
            process.send_signal(signal.SIGINT)
            session.run(PATIENCE_S)
        if process.returncode is None:
            process.send_signal(signal.SIGKILL)


def _take_number(words: list[str], option: str) -> float | None:
    """The number behind an option of ours, which is taken out of the words; None when it is not there."""
    if option not in words:
        return None
    position = words.index(option)
    _, *value = words[position : position + 2]
    del words[position : position + 2]
    try:
        number = float(value[0]) if value else -1.0
    except ValueError:
        number = -1.0
    if not 0 <= number <= 1e6:
        raise UnusableInput(
            f'{option} needs a number from 0 to 1000000, not {value[0] if value else "nothing"!r}',
            help=f'for example: {option} 5',
        )
    return number
