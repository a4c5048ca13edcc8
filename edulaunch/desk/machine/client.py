"""A terminal's side: hands the command to the machine and shows what comes back, on a keyboard or to a program that asks.

Standard library only.
"""

from __future__ import annotations

import os
import select
import signal
import socket
import sys
import time
from collections.abc import Callable, Mapping, Sequence

from edulaunch.desk.machine import wire
from edulaunch.desk.machine.keyboard import Keyboard
from edulaunch.desk.machine.place import (
    LISTENER,
    Address,
    UnsafePlace,
    domain,
    folder,
    listen,
    locked,
    log_file,
    read_address,
    write_address,
)

TYPE_CHECKING = False  # as `typing.TYPE_CHECKING`, without loading `typing`
if TYPE_CHECKING:
    from types import FrameType

PASSED_ON = ('SIGINT', 'SIGTERM', 'SIGQUIT')
PATIENCE = 4
"""How many signals without any answer make a terminal give up."""
GAVE_UP = 130
BROKEN_PIPE = 141


def run(words: Sequence[str], *, start: bool = True) -> int:
    """Run a command on the machine of this domain, in this terminal; returns its exit code.

    :param start: whether to start a machine when there is none; else a sentence says that there is none.
    """
    _open_the_closed()
    for _ in range(3):  # a machine may end just when we come
        try:
            found = connect(domain(), start=start)
        except (UnsafePlace, OSError) as error:
            return _failed(str(error))
        if found is None:
            return _failed(f'no machine is running in ROS_DOMAIN_ID {domain()}: any `ros2` command starts one')
        client, token = found
        with client:
            code = Client(client).run(hello(token, words))
        if code is not None:
            return code
    return _failed(f'the machine does not answer\n  help: see {log_file(folder(), domain())}')


def _open_the_closed() -> None:
    """Let 0, 1 and 2 be files: what is opened later must not take the place of a closed one."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)


def _failed(why: str) -> int:
    sys.stderr.write(f'error: {why}\n')
    return 1


def connect(number: str, *, start: bool = True) -> tuple[socket.socket, str] | None:
    """A connection to the machine of a domain, and what one says first on it; None when there is none and `start` is false.

    Of two terminals that come first at the same time one starts the machine, and both are connected to it: the socket listens
    before the machine runs.

    :raises UnsafePlace: when the folder of the machines is not this user's alone.
    """
    place = folder()
    found = _try(read_address(place, number))
    if found is not None or not start:
        return found
    with locked(place, number):
        found = _try(read_address(place, number))
        if found is None:
            listener, address = listen(place, number, 'terminals')
            address.pid = _spawn(listener, place, number)
            write_address(place, number, address)
            listener.close()
            found = _try(address)
    return found


def _try(address: Address | None) -> tuple[socket.socket, str] | None:
    if address is None:
        return None
    client = socket.socket(socket.AF_INET if address.kind == 'tcp' else socket.AF_UNIX)
    try:
        client.connect(('127.0.0.1', int(address.place)) if address.kind == 'tcp' else address.place)
    except (OSError, ValueError):
        client.close()
        return None
    return client, address.token


def _spawn(listener: socket.socket, place: str, number: str) -> int:
    """Start the machine as a process that belongs to no terminal; returns its pid. What it complains of is in a file."""
    reader, writer = os.pipe()
    child = os.fork()
    if child:
        os.close(writer)
        os.waitpid(child, 0)
        with open(reader, 'rb') as answer:
            return int(answer.read() or 0)
    try:
        os.setsid()
        if os.fork() == 0:
            os.write(writer, str(os.getpid()).encode())
            _become_machine(listener, place, number)
    finally:
        os._exit(0)


def _become_machine(listener: socket.socket, place: str, number: str) -> None:
    complaints = os.open(log_file(place, number), os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    nothing = os.open(os.devnull, os.O_RDWR)
    ours = os.dup(listener.fileno())
    for number_here, file in ((0, nothing), (1, complaints), (2, complaints), (LISTENER, ours)):
        if number_here == file:
            os.set_inheritable(file, True)
        else:
            os.dup2(file, number_here)
    os.closerange(LISTENER + 1, 256)
    os.chdir('/')
    words = [sys.executable, '-m', 'edulaunch.desk.machine.serving', place, number]
    os.execv(sys.executable, words)


def hello(
    token: str, words: Sequence[str], cwd: str | None = None, env: Mapping[str, str] | None = None, keyboard: bool = True
) -> bytes:
    """The first frame: who we are, where we are, and what to run."""
    columns, lines = _size()
    terminals = ''.join('1' if keyboard and os.isatty(number) else '0' for number in range(3))
    variables = [f'{name}={value}' for name, value in (os.environ if env is None else env).items()]
    fields = [token, cwd or os.getcwd(), str(columns), str(lines), terminals, str(len(words)), *words, *variables]
    return wire.frame(wire.HELLO, wire.pack(fields))


def _size() -> tuple[int, int]:
    for number in (1, 0, 2):
        try:
            columns, lines = os.get_terminal_size(number)
        except OSError:
            continue
        return columns, lines
    return 80, 24


class Client:
    """One command in this terminal. Ctrl-C is passed on: what it does is the program's choice."""

    def __init__(self, connection: socket.socket) -> None:
        self._connection = connection
        self._keyboard = Keyboard()
        self._frames = wire.Frames(wire.FROM_MACHINE)
        self._reads = False
        self._welcome = False
        self._unanswered = 0

    def run(self, first: bytes) -> int | None:
        """Follow the command to its end; returns its exit code, None when the machine was never there."""
        handlers = {name: signal.signal(getattr(signal, name), self._pass_on) for name in PASSED_ON if hasattr(signal, name)}
        if hasattr(signal, 'SIGWINCH'):
            handlers['SIGWINCH'] = signal.signal(signal.SIGWINCH, self._tell_size)
        try:
            return self._follow(first)
        except _NobodyReads:
            return BROKEN_PIPE
        except _CannotWrite as error:
            return _failed(f'what the command says cannot be written: {error}')
        except (ConnectionError, wire.BadFrame):
            return self._lost()
        except _GaveUp:
            sys.stderr.write('\nthe machine does not answer; this terminal has left it\n')
            return GAVE_UP
        finally:
            self._keyboard.restore()
            for name, handler in handlers.items():
                signal.signal(getattr(signal, name), handler)

    def _lost(self) -> int | None:
        if not self._welcome:
            return None
        return _failed(f'the machine has ended\n  help: see {log_file(folder(), domain())}')

    def _follow(self, first: bytes) -> int | None:
        self._connection.sendall(first)
        poll = select.poll()
        poll.register(self._connection, select.POLLIN)
        while True:
            for number, _ in poll.poll():
                if number == 0:
                    self._pass_keys(poll)
                    continue
                data = self._connection.recv(1 << 16)
                if not data:
                    return self._lost()
                self._unanswered = 0
                for kind, payload in self._frames.feed(data):
                    if kind == wire.EXIT:
                        return int(payload)
                    self._take(kind, payload, poll)

    def _take(self, kind: bytes, payload: bytes, poll: select.poll) -> None:
        if kind == wire.WELCOME:
            self._welcome = True
        elif kind == wire.MODE:
            self._keyboard.set_mode(int(payload))
        elif kind == wire.READ and not self._reads:
            self._reads = True
            poll.register(0, select.POLLIN)
        elif kind in (wire.OUTPUT, wire.ERRORS):
            _write(1 if kind == wire.OUTPUT else 2, payload)

    def _pass_keys(self, poll: select.poll) -> None:
        try:
            keys = os.read(0, 1 << 12)
        except OSError:  # closed, or not ours to read
            keys = b''
        self._connection.sendall(wire.frame(wire.INPUT, keys))
        if not keys:
            poll.unregister(0)

    def _pass_on(self, signum: int, frame: FrameType | None) -> None:
        self._unanswered += 1
        if self._unanswered >= PATIENCE:
            raise _GaveUp
        self._tell(wire.SIGNAL, str(int(signum)))

    def _tell_size(self, signum: int, frame: FrameType | None) -> None:
        self._tell(wire.SIZE, '{} {}'.format(*_size()))

    def _tell(self, kind: bytes, text: str) -> None:
        try:
            self._connection.sendall(wire.frame(kind, text.encode()))
        except OSError:
            return  # reading from it tells


class _GaveUp(Exception):
    """Nothing came back for too long."""


class _CannotWrite(Exception):
    """What the command says has no place: a full disk."""


class _NobodyReads(Exception):
    """The pipe that we write into is closed at its other end."""


def _write(number: int, data: bytes) -> None:
    try:
        while data:
            data = data[os.write(number, data) :]
    except BrokenPipeError:
        raise _NobodyReads from None
    except OSError as error:
        raise _CannotWrite(error.strerror) from None


def has_terminals_machine() -> bool:
    """Whether terminals have started a machine in this domain that is running."""
    try:
        address = read_address(folder(), domain())
        found = connect(domain(), start=False) if address is not None and address.host == 'terminals' else None
    except (UnsafePlace, OSError):
        return False
    if found is not None:
        found[0].close()
    return found is not None


def ask(words: Sequence[str], write: Callable[[str, str], object], *, seconds: float | None = None) -> int | None:
    """Run a command on the machine that is running; returns its exit code, None when there is no machine.

    :param write: called as write('stdout' | 'stderr', text).
    :param seconds: real time after which Ctrl-C is pressed.
    """
    found = connect(domain(), start=False)
    if found is None:
        return None
    connection, token = found
    frames = wire.Frames(wire.FROM_MACHINE)
    deadline = None if seconds is None else time.monotonic() + seconds
    with connection:
        connection.sendall(hello(token, words, keyboard=False))
        while True:
            connection.settimeout(None if deadline is None else max(0.001, deadline - time.monotonic()))
            try:
                data = connection.recv(1 << 16)
            except TimeoutError:
                deadline = None
                connection.sendall(wire.frame(wire.SIGNAL, str(int(signal.SIGINT)).encode()))
                continue
            for kind, payload in frames.feed(data):
                if kind in (wire.OUTPUT, wire.ERRORS):
                    write('stdout' if kind == wire.OUTPUT else 'stderr', payload.decode('utf-8', 'replace'))
                elif kind == wire.EXIT:
                    return int(payload)
            if not data:
                return None
