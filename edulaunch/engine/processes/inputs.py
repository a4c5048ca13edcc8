"""The inputs of simulated programs: a string, lines at given times, or a pipe. (`RealInput`, in `real.py`, is a real keyboard.)

Reading waits in simulated time; meanwhile, the other programs continue.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from edulaunch.engine.sim.sync import wait_until
from edulaunch.engine.sim.task import Task, current_task

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process


class Input:
    """`sys.stdin` of a simulated program: a string that was given before the program started. Subclasses define other sources.

    A program that reads key by key (see the `termios` view) has a keyboard instead: after the last key, reading waits forever.

    :ivar by_key: whether the program has switched off the line mode of the terminal.
    :ivar blocking: whether reading waits (see the `fcntl` view).
    :ivar is_inherited: whether the program's children read from this input, too.
    """

    name = '<stdin>'
    encoding = 'utf-8'
    errors = 'strict'
    mode = 'r'
    newlines = None
    closed = False
    by_key = False
    blocking = True
    is_inherited = False

    def __init__(self, text: str = '') -> None:
        self._text = text

    def has_ended(self) -> bool:
        """Return whether no more input will arrive."""
        return True

    def take_more(self, deadline_ns: int | None) -> bool:
        """Wait for more input, and add it to the unread input. Return False if the deadline comes first.

        :param deadline_ns: a simulated time in nanoseconds, or None for no deadline.
        """
        return False

    def take_due(self) -> None:
        """Add the input that has already arrived to the unread input, without waiting."""

    def is_ready(self) -> bool:
        """Return whether a program could read without waiting."""
        self.take_due()
        return bool(self._text) or (self.has_ended() and not self.by_key)

    def change_mode(self, process: Process, flags: int) -> None:
        """Set the local flags of the terminal; see the `termios` view."""
        import termios

        self.by_key = not flags & termios.ICANON

    def terminal_size(self) -> tuple[int, int]:
        """Raise an OSError, because the input is not a terminal.

        A subclass for a terminal would return its columns and lines.
        """
        raise OSError(25, 'Inappropriate ioctl for device')

    def wait(self, timeout_s: float | None) -> bool:
        """Wait until there is input to read, and return True. Return False after `timeout_s` simulated seconds."""
        task = current_task()
        deadline = None if timeout_s is None else task.sim.now_ns + round(timeout_s * 1e9)
        while not self.is_ready():
            if self.has_ended():
                self._wait_for_ever(deadline)
                return False
            if not self.take_more(deadline) and deadline is not None and task.sim.now_ns >= deadline:
                return False
        task.poll()
        return True

    def _wait_for_ever(self, deadline_ns: int | None = None) -> None:
        """Wait for a key that is never pressed. Only the deadline or a signal can end this wait."""
        task = current_task()
        while deadline_ns is None or task.sim.now_ns < deadline_ns:
            task.park(deadline_ns)

    def _fill(self, size: int, end: str = '') -> None:
        """Wait for `size` characters (-1 for all), for `end`, or for the end of the input."""
        self.take_due()
        while (size < 0 or len(self._text) < size) and not (end and end in self._text) and not self.has_ended():
            if not self.blocking:
                break
            self.take_more(None)
        if not self._text:
            if self.by_key and self.blocking:
                self._wait_for_ever()
            current_task().poll()  # an endless reading loop must not stop simulated time

    def _cut(self, length: int) -> str:
        text, self._text = self._text[:length], self._text[length:]
        return text

    def read(self, size: int | None = -1, /) -> str:
        """Read like `io.TextIOBase.read`, but wait after the last key of a keyboard."""
        size = -1 if size is None else size
        self._fill(size)
        return self._cut(len(self._text) if size < 0 else size)

    def read1(self, size: int) -> str:
        """Return at most `size` of the available characters. If there is no character, wait for the first character."""
        self._fill(1)
        return self._cut(size)

    def readline(self, size: int = -1, /) -> str:
        """Read a line like `io.TextIOBase.readline`, but wait after the last key of a keyboard."""
        self._fill(size, '\n')
        end = self._text.find('\n') + 1 or len(self._text)
        return self._cut(end if size < 0 else min(size, end))

    def readlines(self, hint: int = -1, /) -> list[str]:
        """Return all lines until the end of the input."""
        return list(self)

    def __iter__(self) -> Iterator[str]:
        return iter(self.readline, '')

    def __next__(self) -> str:
        line = self.readline()
        if not line:
            raise StopIteration
        return line

    @property
    def buffer(self) -> BytesInput:
        """The binary stream of the same input."""
        return BytesInput(self)

    def isatty(self) -> bool:
        """Return False, because a launched program does not read from a terminal."""
        return False

    def fileno(self) -> int:
        """Return 0, the number of standard input in every program."""
        return 0

    def readable(self) -> bool:
        """Return True."""
        return True

    def writable(self) -> bool:
        """Return False."""
        return False

    def seekable(self) -> bool:
        """Return False."""
        return False

    def flush(self) -> None:
        """Do nothing, because an input has no buffer to write."""

    def close(self) -> None:
        """Do nothing, because the input does not use a resource of the operating system."""


class SilentPipe(Input):
    """The input of a launched program: a pipe that stays open without any data, as in ROS 2."""

    is_inherited = True
    _has_warned = False

    def has_ended(self) -> bool:
        """Return False, because the pipe stays open."""
        return False

    def take_more(self, deadline_ns: int | None) -> bool:
        """Wait until the deadline, or until a signal ends the program. Record as a fact that the program waits without a
        deadline.
        """
        process: Process = current_task().owner
        if deadline_ns is None and not self._has_warned:
            self._has_warned = True
            process.fact('waits for input', None, {})
        self._wait_for_ever(deadline_ns)
        return False


class BytesInput:
    """`sys.stdin.buffer` of a simulated program; strings are encoded in UTF-8."""

    def __init__(self, text: Input) -> None:
        self._input = text

    def read(self, size: int = -1) -> bytes:
        """Read like `read` of a binary file."""
        return self._input.read(size).encode()

    def readline(self) -> bytes:
        """Read a line like `readline` of a binary file."""
        return self._input.readline().encode()

    def __iter__(self) -> Iterator[bytes]:
        return iter(self.readline, b'')


class TypedInput(Input):
    """An input in which strings arrive at given times, as if a person typed them.

    :param pieces: pairs (simulated seconds since the start, string), in any order.
    """

    def __init__(self, pieces: Sequence[tuple[float, str]]) -> None:
        super().__init__()
        self._pieces = deque(sorted(((round(seconds * 1e9), text) for seconds, text in pieces), key=lambda piece: piece[0]))

    def has_ended(self) -> bool:
        """Return whether the last string has arrived."""
        return not self._pieces

    def take_due(self) -> None:
        """Add the strings whose time has come to the unread input."""
        sim = current_task().sim
        while self._pieces and self._pieces[0][0] <= sim.now_ns - sim.start_ns:
            self._text += self._pieces.popleft()[1]

    def take_more(self, deadline_ns: int | None) -> bool:
        """Wait until the next string arrives. Return False if the deadline comes first."""
        task = current_task()
        due = task.sim.start_ns + self._pieces[0][0]
        task.sleep_until(due if deadline_ns is None else min(due, deadline_ns))
        self.take_due()
        return deadline_ns is None or due <= deadline_ns


class PipedInput(Input):
    """The end of `Popen(..., stdin=PIPE).stdin` from which the child reads."""

    def __init__(self) -> None:
        super().__init__()
        self._open = True
        self._waiters: deque[Task] = deque()

    def feed(self, text: str, *, last: bool = False) -> None:
        """Add a string to the unread input. With `last`, the input ends after this string."""
        self._text += text
        self._open = self._open and not last
        for task in self._waiters:
            task.wake()

    def has_ended(self) -> bool:
        """Return whether the other end of the pipe is closed."""
        return not self._open

    def take_more(self, deadline_ns: int | None) -> bool:
        """Wait until the other program writes to the pipe or closes it. Return False if the deadline comes first."""
        length = len(self._text)
        timeout = None if deadline_ns is None else max(0, deadline_ns - current_task().sim.now_ns) / 1e9
        return wait_until(lambda: len(self._text) > length or not self._open, self._waiters, timeout)
