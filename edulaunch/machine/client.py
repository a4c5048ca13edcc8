"""A terminal's side: hands the command to the machine and shows what comes back. Standard library only."""

from __future__ import annotations

import os
import select
import signal
import socket
import sys
from collections.abc import Mapping, Sequence

from edulaunch.machine import wire
from edulaunch.machine.keyboard import Keyboard
from edulaunch.machine.place import UnsafePlace, domain, folder
from edulaunch.machine.starting import connect, log_file

TYPE_CHECKING = False
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


class _NobodyReads(Exception):
    """The pipe that we write into is closed at its other end."""


def _write(number: int, data: bytes) -> None:
    try:
        while data:
            data = data[os.write(number, data) :]
    except BrokenPipeError:
        raise _NobodyReads from None
