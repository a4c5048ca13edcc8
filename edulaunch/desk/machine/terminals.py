"""The machine's side of terminals. Each terminal runs one command inside the simulation, or a command for the machine itself
(`edulaunch machine status|stop|pause|resume|speed X`, `edulaunch network ...`).

The recorded output of `ros2 doctor` contains only ROS 2's own checks, not the advice that follows them. Recordings contain no
sentences in a user's language.
"""

from __future__ import annotations

import os
import signal
from codecs import getincrementaldecoder
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from edulaunch.advice.judging import in_order
from edulaunch.advice.reader import Reader, reader_of
from edulaunch.advice.rendering import diagnosis, end_of_run_lines
from edulaunch.desk.machine import wire
from edulaunch.desk.machine.connection import RemoteInput
from edulaunch.desk.machine.live import LiveMachine
from edulaunch.desk.machine.notes import Notes
from edulaunch.engine.processes.process import Process
from edulaunch.errors import UnusableInput
from edulaunch.runtime import plugins
from edulaunch.runtime.session import Session, typed_command

if TYPE_CHECKING:
    from edulaunch.desk.machine.connection import Connection, Peer
    from edulaunch.desk.machine.live_page import LivePage

FASTEST, SLOWEST = 100.0, 0.01
NOT_FOUND = 127
NOTES_WITHIN = 50
"""After this many writes, a terminal gets no more notes about its programs."""
MOST_PAGES = 256
"""The maximum number of open live views; the other connections are for terminals."""
ADVISED = (['ros2', 'launch'], ['ros2', 'run'])
"""Commands that end with advice on what is wrong."""
MOST_JUDGED = 8
"""`ros2 doctor` examines this many of the last commands."""
HUP = getattr(signal, 'SIGHUP', signal.SIGTERM)


def is_doctor(words: Sequence[str]) -> bool:
    """Return whether a command is `ros2 doctor` (or `ros2 wtf`) without a report."""
    return (
        len(words) > 1 and words[0] == 'ros2' and words[1] in ('doctor', 'wtf') and not {'hello', '-r', '--report'} & set(words)
    )


def doctors_text(session: Session, reader: Reader) -> str:
    """Return the findings about the last launches and programs that terminals have run. Each run is checked separately."""
    heading = reader.says('edulaunch has checked everything that ran here so far:')
    judged = [
        row['pid'] for row in session.recorder.processes if row['argv'][:2] in ADVISED and session.recorder.leads(row['pid'])
    ]
    findings = in_order([one for pid in judged[-MOST_JUDGED:] for one in session.of_command(pid).advice])
    return '\n'.join((heading, *diagnosis(findings, reader), ''))


def run_words(terminals: Terminals, words: list[str], env: Mapping[str, str], say: Callable[[str], object]) -> int:
    """Run a command for the machine itself. Return the exit code.

    :param terminals: the terminals of the machine.
    :param words: the command, such as ['speed', '2'].
    :param env: the environment of the command.
    :param say: a function that writes to the terminal.
    """
    word, value = (words + ['status', ''])[:2] if words else ('status', '')
    if word == 'network':
        try:
            network = terminals.machine.switch()
        except UnusableInput as error:
            say(f'error: {error}\n')
            return 2
        return network.run(words[1:], env, say, terminals.machine.tell)
    if terminals.time.is_wall and word in ('pause', 'resume', 'speed'):
        say('the network is on, so simulated time must equal real time\n  help: leave it first: edulaunch network off\n')
        return 1
    if word == 'status':
        say(status(terminals))
    elif word == 'stop':
        terminals.is_asked_to_end = True
        say('stopping the machine\n')
    elif word in ('pause', 'resume'):
        terminals.time.paused = word == 'pause'
        say(f'time {"is paused" if terminals.time.paused else "continues"} at {terminals.session.sim.elapsed_s:.3f} s\n')
    elif word == 'speed':
        return _set_speed(terminals, value, say)
    else:
        say(f'unknown word {word!r}: status, stop, pause, resume or speed X\n')
        return 2
    return 0


def _set_speed(terminals: Terminals, value: str, say: Callable[[str], object]) -> int:
    try:
        speed = float(value)
    except ValueError:
        speed = 0.0
    if not SLOWEST <= speed <= FASTEST:
        say(f'invalid speed {value!r}: give simulated seconds per second, from {SLOWEST} to {FASTEST:.0f}\n')
        return 2
    terminals.time.speed = speed
    say(f'speed: {speed:g} simulated seconds per second\n')
    return 0


def status(terminals: Terminals) -> str:
    """Return a description of the machine and of the commands that run on it."""
    time, session = terminals.time, terminals.session
    pace = 'paused' if time.paused else f'speed {time.speed:g}'
    lines = [f'machine: process {os.getpid()}, {session.sim.elapsed_s:.1f} s old, {pace}']
    for terminal in terminals.open_ones:
        programs = len(terminal.programs())
        lines.append(f'terminal {terminal.number}: {" ".join(terminal.words)} ({programs} program{"s" * (programs != 1)})')
    return '\n'.join(lines) + '\n'


class Terminals:
    """All terminals of a machine's current session, in the order in which they connected.

    :param machine: the machine that runs their commands.
    :ivar pages: the live views that show the machine.
    :ivar is_asked_to_end: whether a user has stopped the machine.
    """

    def __init__(self, machine: LiveMachine) -> None:
        self.machine = machine
        self.session = session = machine.session
        self.time = machine.time
        machine.listeners.append(self.warn)
        session.host.join_network, session.host.where_on_network = self._join_network, self._where_on_network
        self.open_ones: list[Terminal] = []
        self.pages: list[LivePage] = []
        self.is_asked_to_end = False
        self.notes = Notes()
        self._count = 0

    def warn(self, text: str) -> None:
        """Print a warning in every terminal in which a command runs."""
        for terminal in self.open_ones:
            terminal.show('stderr', f'warning: {text}\n')

    def _join_network(self, env: Mapping[str, str], words: Sequence[str], say: Callable[[str], object]) -> Callable[[], object]:
        return self.machine.switch().join(env, words, self.machine.tell, say)

    def _where_on_network(self) -> str | None:
        network = self.machine.network
        return network.where() if network is not None and network.is_on else None

    def open(self, connection: Connection, fields: list[str]) -> Peer:
        """Create the terminal, live view or peer of a plug-in that the first frame of a connection requests.

        :param connection: the connection.
        :param fields: the content of the first frame, without the token.
        :raises ValueError: when the frame is invalid.
        :raises IndexError: when the frame is too short.
        """
        cwd, columns, lines, terminals, count = fields[:5]
        words, variables = fields[5 : 5 + int(count)], fields[5 + int(count) :]
        if not words or len(terminals) != 3:
            raise ValueError('no command')
        if words == ['machine', 'view']:
            from edulaunch.desk.machine.live_page import LivePage

            if len(self.pages) >= MOST_PAGES:
                why = f'{MOST_PAGES} pages already show this machine: close some of them, and load this page again'
                connection.send(wire.ERRORS, why.encode())
                connection.end()
            page = LivePage(self.machine, connection.send, self.pages.remove, (cwd, _variables(variables)))
            self.pages.append(page)
            self.notes.knows_view = True
            return page
        if words[:2] == ['machine', 'serve'] and (service := plugins.service(words[2])) is not None:
            peer: Peer = service.peer(self.machine, connection)
            return peer
        self._count += 1
        env = _variables(variables)
        terminal = Terminal(self, connection, (int(columns), int(lines)), terminals)
        terminal.words = words
        terminal.number = self._count
        if words[0] == 'machine':
            code = run_words(self, words[1:], env, lambda text: connection.send(wire.OUTPUT, text.encode()))
            terminal.ended(code)
        else:
            terminal.start(words, cwd, env)
        return terminal


class Terminal:
    """One terminal with its command.

    :param size: the columns and lines of the window.
    :param terminals: three characters for stdin, stdout and stderr. '1' means that the client's stream is a terminal, '0' that
        it is not.
    """

    def __init__(self, terminals: Terminals, connection: Connection, size: tuple[int, int], terminals_there: str) -> None:
        self._terminals = terminals
        self._connection = connection
        self._terminals_there = terminals_there
        self._decoder = getincrementaldecoder('utf-8')('replace')
        self.words: list[str] = []
        self.number = self._writes = 0
        self.process: Process | None = None
        self.input = RemoteInput(connection.send, terminals_there[0] == '1', size)

    def start(self, words: list[str], cwd: str, env: dict[str, str]) -> None:
        """Run the command inside the simulation.

        :param words: the command.
        :param cwd: the current folder of the terminal.
        :param env: the environment of the terminal.
        """
        host = self._terminals.session.host
        name = words[3] if words[:2] == ['ros2', 'run'] and words[3:] else words[0]
        spec, index = typed_command(words, f'{name}-{self.number}', cwd, env, host.index)
        if not host.knows(spec):
            self._connection.send(wire.ERRORS, f'{words[0]}: unknown command on the simulated machine\n'.encode())
            self.ended(NOT_FOUND)
            return
        self._reader = reader_of(env, cwd)
        process = host.start(spec, self.show, self._finished, index=index)
        assert isinstance(process, Process)
        streams = process.streams
        streams.stdin = self.input
        streams.stdout.is_terminal, streams.stderr.is_terminal = (sign == '1' for sign in self._terminals_there[1:])
        self.process = process
        self._terminals.open_ones.append(self)
        if self._terminals_there[2] == '1':
            self._connection.send(wire.ERRORS, ''.join(self._terminals.notes.same_names(words, [process])).encode())

    def show(self, stream: str, text: str) -> None:
        """Write output to this terminal, and the notes that are due.

        :param stream: 'stdout' or 'stderr'.
        :param text: the output.
        """
        self._connection.send(wire.OUTPUT if stream == 'stdout' else wire.ERRORS, text.encode('utf-8', 'backslashreplace'))
        if self._terminals_there[2] == '1' and self._writes < NOTES_WITHIN:
            self._writes += 1
            for note in self._terminals.notes.about(self.words, self.programs()):
                self._connection.send(wire.ERRORS, note.encode())

    def _finished(self, code: int) -> None:
        """Print advice on the launches and programs of the command, which has ended, and end the terminal."""
        if self.process is not None and self.words[:2] in ADVISED and '--quiet' not in self.words:
            session, typed, pid = self._terminals.session, self.process.name, self.process.pid
            lines = end_of_run_lines(session.of_command(pid), self._reader, session.host.hints.helped(pid), typed, 'ros2 doctor')
            self.show('stderr', ''.join(f'{line}\n' for line in lines))
        elif is_doctor(self.words):
            self.show('stdout', doctors_text(self._terminals.session, self._reader))
        self.ended(code)

    def ended(self, code: int) -> None:
        """Send the exit code of the command to the client, and end the terminal.

        :param code: the return code, which is negative after a signal.
        """
        self._connection.send(wire.EXIT, str(code if code >= 0 else 128 - code).encode())
        self._connection.end()

    def take(self, kind: int, payload: bytes) -> None:
        """Handle a frame of the client: input, a signal or a new window size."""
        if kind == wire.INPUT:
            self.input.feed(self._decoder.decode(payload), last=not payload)
        elif kind == wire.SIGNAL:
            self.signal(int(payload))
        elif kind == wire.SIZE:
            columns, lines = map(int, payload.split())
            self.input.size = columns, lines

    def signal(self, signum: int, running: Process | None = None) -> None:
        r"""Send Ctrl-C and Ctrl-\ to every program of the terminal, and other signals to its command.

        :param signum: the number of the signal.
        :param running: the program that runs now and is interrupted, or None. An exception that the signal raises in this program
            leaves this method.
        """
        if self.process is None:
            return
        reached = [self.process]
        if self.input.isatty() and signum in (signal.SIGINT, getattr(signal, 'SIGQUIT', None)):
            reached = [program for program in self.programs() if not program.is_passed_on]
        if running is not None:  # the process that passes the signal on does not get a turn while another one runs
            reached = [*([] if running.is_passed_on else [each for each in reached if each is not running]), running]
        if running is None:
            self._terminals.session.let_go()
        for program in reached:
            program.send_signal(signum)

    def programs(self) -> list[Process]:
        """Return the programs that run in the terminal. The command comes first."""
        processes = self._terminals.session.host.processes
        return [process for process in processes if process.group is self.process]

    def hang_up(self) -> None:
        """Send SIGHUP to the programs that still run after the client has closed the connection."""
        if self in self._terminals.open_ones:
            self._terminals.open_ones.remove(self)
        host = self._terminals.session.host
        self._terminals.session.let_go()
        for program in self.programs():
            program.send_signal(HUP)
        for real in [real for real in host.real_programs if real.group is self.process]:
            real.send_signal(HUP)


def _variables(lines: Sequence[str]) -> dict[str, str]:
    """Return the environment variables that a terminal has sent as strings `NAME=VALUE`."""
    return dict(line.split('=', 1) for line in lines if '=' in line)
