"""`edulaunch launch`: run a launch file in the simulation, with the console output of `ros2 launch`."""

from __future__ import annotations

import argparse
import os
import shlex
import signal
import sys
import time
from collections.abc import Callable
from contextlib import nullcontext
from types import FrameType
from typing import TextIO

from edulaunch.advice.rendering import end_of_run_lines
from edulaunch.desk.cli.launch_steps import TerminalSteps
from edulaunch.desk.cli.plugin_options import plugins_of
from edulaunch.desk.cli.ros2.launch import add_launch_arguments, prefix_arguments
from edulaunch.engine.packages.discovery import folder_of, workspaces_of_command
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.frame_owner import ENGINE, LIBRARIES
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.safe_file import remove_drafts
from edulaunch.engine.sim.pacing import Pacer
from edulaunch.errors import LaunchFileError, UnusableInput
from edulaunch.runtime.interrupt_watcher import WatchedSignals, watched_signals
from edulaunch.runtime.keeping import Ending, Reserve, advice_or_why_not, first_interrupt_waits, spent
from edulaunch.runtime.last_moment import KILLED, last_moment
from edulaunch.runtime.launch_process import LaunchRun, explain
from edulaunch.runtime.launching import find_launch_file, launch_argument
from edulaunch.runtime.session import Session
from edulaunch.runtime.still_busy import StillBusy


def launch_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of `ros2 launch`, and options for duration, speed, seed and recording."""
    parser.add_argument('package_or_path', metavar='PACKAGE | PATH', help='package of the launch file, or path of a launch file')
    parser.add_argument('rest', nargs='*', default=[], metavar='FILE | name:=value', help='launch file name, launch arguments')
    add_launch_arguments(parser)
    parser.add_argument(
        '--for', dest='seconds', type=_seconds, metavar='SECONDS', help='press Ctrl-C after this many simulated seconds'
    )
    parser.add_argument(
        '--stdin',
        action='append',
        default=[],
        type=_stdin,
        metavar='NAME=FILE',
        help='read the keyboard input of the program NAME from a file, or from this terminal (-); may be repeated',
    )
    parser.add_argument('--step', action='store_true', help='stop before each action of the launch file, and show a prompt')
    parser.add_argument('--fast', action='store_true', help='run as fast as possible instead of in real time')
    parser.add_argument('--seed', type=_whole, default=0, help='seed of all random numbers (default: 0)')
    parser.add_argument('--record', metavar='FILE', help='write a recording of the run')
    parser.add_argument(
        '--view', metavar='FILE', nargs='?', const='', help='write an HTML page that replays the run (default name: NAME.html)'
    )
    parser.add_argument(
        '--workspace',
        action='append',
        default=[],
        metavar='DIR',
        help='folder with packages, may be repeated (default: the workspace of this folder, as if it was sourced)',
    )


def _whole(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f'{text!r} is not a whole number; write a number, as in --seed 7') from None


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f'{text!r} is not a number of seconds; write a number, as in --for 10') from None
    if not 0 <= value <= 1e6:
        raise argparse.ArgumentTypeError(f'{text} is not between 0 and 1000000 seconds')
    return value


def launch_verb(arguments: argparse.Namespace) -> int:
    """Run the launch file. Return 0 if launch succeeded, 1 if it failed, and 2 for invalid input.

    As in ROS 2, launch succeeds even if a node dies.
    """
    package_or_path, file, given = split_words(arguments.package_or_path, arguments.rest)
    for folder in arguments.workspace:
        if not os.path.isdir(folder):
            raise UnusableInput(f'workspace {folder!r} is not a folder.', help='name a folder with packages after --workspace')
    given.update(prefix_arguments(arguments))
    interactive = sys.stdin.isatty() and not arguments.noninteractive
    env = {**os.environ, 'OVERRIDE_LAUNCH_PROCESS_OUTPUT': 'both'} if arguments.show_all_subprocesses_output else None
    with (
        Ending() as ending,
        _session_class(arguments)(
            seed=arguments.seed,
            workspaces=workspaces_of_command(arguments.workspace, package_or_path),
            near=folder_of(package_or_path),
            console=_print,
            env=env,
            stdin=dict(arguments.stdin),
        ) as session,
    ):
        if arguments.show_args or arguments.print:
            return _look(session, find_launch_file(session.index, package_or_path, file), arguments.show_args)
        if arguments.record:
            remove_drafts(arguments.record)
        launch = session.launch(package_or_path, file, given, interactive=interactive, debug=arguments.debug)
        terminal = InterruptHandler(session, arguments.seconds, ending, _clock(arguments, session))
        with first_interrupt_waits('still writing the recording; press Ctrl-C again to stop without it'):
            error = _run(terminal, session, ending, arguments)
            recording = session.recording()
            if arguments.record:
                recording.save(arguments.record)
        ending.is_saving = False
        if error is not None and (known := spent(error)) is None:
            raise error
        for line in [] if arguments.quiet else _advice(recording, session, launch):
            print(line, file=sys.stderr)
        _print_end(arguments, session, recording, launch.path)
        if error is not None and known is not None:
            raise known from None
        if ending.came is not None:
            print(f'note: {ending.text(recording.duration_s)}', file=sys.stderr)
            return 128 + ending.came
    return 0 if launch.process.returncode is None else launch.process.returncode


def _clock(arguments: argparse.Namespace, session: Session) -> Callable[[], float]:
    """Return the clock for pacing. With `--step`, this clock does not count the time at the prompt."""
    if not arguments.step:
        return time.monotonic
    steps = TerminalSteps(session)
    steps.begin()
    return steps.clock


def _run(terminal: InterruptHandler, session: Session, ending: Ending, arguments: argparse.Namespace) -> BaseException | None:
    """Run the session to its end. Return the exception that ended the run early, or None."""
    reserve, error = Reserve(), None

    def save() -> None:
        reserve.release()
        session.note_end()
        session.recording().save(arguments.record)
        print(f'recording: {arguments.record} (to the end of the run in C code)', file=sys.__stderr__, flush=True)

    try:
        with last_moment(save) if arguments.record else nullcontext():
            terminal.run(0.0 if arguments.fast else 1.0, KILLED if arguments.record else 'SIGKILL')
    except BaseException as caught:  # keep the recording first, whatever the exception is
        error = caught
    ending.is_saving = True
    reserve.release()
    if error is not None or ending.came is not None:
        session.note_end()
    return error


def _advice(recording: Recording, session: Session, launch: LaunchRun) -> list[str]:
    """Return the lines of advice about a run."""
    helped = session.host.hints.helped(launch.process.pid)
    shown_by = shlex.join(['edulaunch', 'doctor', launch.path])
    return advice_or_why_not(lambda: end_of_run_lines(recording, helped=helped, shown_by=shown_by))


def _print_end(arguments: argparse.Namespace, session: Session, recording: Recording, path: str) -> None:
    """Print warnings about the command, and the paths of the files that the command has written."""
    for warning in session.index.warnings:
        print(f'warning: {warning}', file=sys.stderr)
    for name in session.host.unread_stdin:
        print(f'warning: --stdin {name}: the launch file started no program of this name', file=sys.stderr)
    if arguments.record:
        summary = f'{recording.duration_s:.2f} s, digest {recording.digest()[:16]}'
        print(f'recording: {arguments.record} ({summary})', file=sys.stderr)
    if arguments.view is not None:
        from edulaunch.desk.cli.recording import write_page

        name = os.path.basename(path).partition('.')[0]
        print(f'view: {write_page(recording, arguments.view or name + ".html")}', file=sys.stderr)


def _session_class(arguments: argparse.Namespace) -> type[Session]:
    """Return the session class of a plug-in whose option is on the command line, or `Session`.

    :raises UnusableInput: when the plug-in cannot run this command.
    """
    found = [options.session_class(arguments) for options in plugins_of(arguments)]
    return next((kind for kind in found if kind is not None), Session)


def _stdin(word: str) -> tuple[str, str | TextIO]:
    name, sign, file = word.partition('=')
    if not (name and sign and file):
        raise argparse.ArgumentTypeError(f'{word!r} is not NAME=FILE')
    if file == '-':
        return name, sys.stdin
    try:
        with open(file, encoding='utf-8') as keys:
            return name, keys.read()
    except (OSError, UnicodeDecodeError) as error:
        raise argparse.ArgumentTypeError(f'{file} cannot be read ({error})') from None


def _look(session: Session, path: str, show_args: bool) -> int:
    """Print the launch arguments or the description of a launch file. Return the exit code.

    :param path: the path of the launch file.
    :param show_args: whether to print the launch arguments; otherwise, print the description.
    :raises LaunchFileError: when the launch file cannot be loaded.
    """
    from ros2launch.api import print_a_launch_file, print_arguments_of_launch_file

    process = current_process()
    process.index, process.host.index = session.index, session.index
    process.env.update(session.host.env)
    try:
        (print_arguments_of_launch_file if show_args else print_a_launch_file)(launch_file_path=path)
    except Exception as error:
        explanation = explain(error, session.index)
        raise LaunchFileError(explanation.text, help=explanation.help) from error
    return 0


def split_words(first: str, rest: list[str]) -> tuple[str, str | None, dict[str, str]]:
    """Split the words of a command line as `ros2 launch` does.

    After a path, all words are launch arguments. After a package, the first word is the name of a launch file.

    :return: the package or path, the file name (or None), and the values of the launch arguments by name.
    :raises UnusableInput: for an argument that is not `name:=value`, with the message of ROS 2.
    """
    file = None
    words = list(rest)
    if words and ':=' not in words[0] and not os.path.isfile(first):
        file = words.pop(0)
    return first, file, dict(map(launch_argument, words))


def _print(stream: str, text: str) -> None:
    sys.stdout.write(text)
    sys.stdout.flush()


class InterruptHandler:
    """Handles Ctrl-C for a running session. The first press shuts the launch down as in ROS 2.

    A press only sets a flag, which the session reads between two steps of the simulation. If the flag of the previous press is
    still set, some program does not yield. The next press then raises KeyboardInterrupt immediately. Later presses force the
    shutdown.
    """

    def __init__(
        self, session: Session, seconds: float | None, ending: Ending | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._session = session
        self._clock = clock
        self._ending = ending
        self._seconds = seconds
        self._pressed = 0
        self._still_busy = StillBusy()
        self._watched = WatchedSignals()

    def run(self, speed: float, end_by: str = 'SIGKILL') -> None:
        """Run the session until launch ends. If the handler has a duration, interrupt launch after that simulated time.

        :param speed: simulated seconds per real second.
        :param end_by: see :func:`watched_signals`.
        """
        sim = self._session.sim
        before = signal.signal(signal.SIGINT, self._press)
        try:
            if self._seconds is not None:
                sim.schedule(sim.now_ns + round(self._seconds * 1e9), self._session.interrupt, priority=1)
            watching = watched_signals((ENGINE, *LIBRARIES), sys.stderr.isatty(), end_by)
            with StillBusy() as self._still_busy, streams_of_programs(), watching as self._watched:
                if self._ending is not None:
                    self._ending.watched = self._watched
                Pacer(sim, speed, clock=self._clock).run(None, self._is_over)
        finally:
            signal.signal(signal.SIGINT, before)

    def _press(self, signum: int, frame: FrameType | None) -> None:
        self._watched.confirm()
        if self._pressed:
            self._pressed = 0
            raise KeyboardInterrupt
        self._pressed = 1
        self._still_busy.press()

    def _is_over(self) -> bool:
        if self._ending is not None and self._ending.came is not None:
            return True
        if self._pressed:
            self._pressed = 0
            self._still_busy.stop()
            self._session.interrupt()
        return self._session.is_over
