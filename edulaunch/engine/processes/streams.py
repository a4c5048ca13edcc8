"""The output streams of a simulated program.

A student's own modules get the streams of their program from the `sys` view. Output of the standard library or an installed
package (warnings, `help()`, progress bars) goes through the real `sys`. While a simulation runs, a
:class:`SharedStream` replaces each stream of the real `sys`. So each call reaches the program that makes it.

Beginners print futures, nodes and methods (`<rclpy.task.Future object at 0x7f0000000010>`). The real addresses differ from
run to run, but recordings must be equal. So the addresses are replaced by numbers, in the order in which they first appear.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from edulaunch.engine.sim.task import AmbientTask, running_task


class OutputStream:
    """`sys.stdout` or `sys.stderr` of a simulated program.

    :param write: called with the name of the stream and a string.
    """

    encoding = 'utf-8'
    errors = 'replace'
    closed = False
    newlines = None
    line_buffering = True
    is_terminal = False

    def __init__(self, write: Callable[[str, str], object], name: str) -> None:
        self._write = write
        self._stream = name
        self.name = f'<{name}>'

    def write(self, text: str) -> int:
        """Write a string immediately, and return its length."""
        if not isinstance(text, str):
            raise TypeError(f'write() argument must be str, not {type(text).__name__}')
        if text:
            self._write(self._stream, text)
        return len(text)

    def writelines(self, lines: list[str]) -> None:
        """Write all lines."""
        for line in lines:
            self.write(line)

    def flush(self) -> None:
        """Do nothing, because nothing is buffered."""

    def isatty(self) -> bool:
        """Return whether the program writes to a terminal; a launched program writes to a pipe."""
        return self.is_terminal

    @property
    def buffer(self) -> BytesOutput:
        """The binary stream with the same output."""
        return BytesOutput(self)

    def reconfigure(self, **_: object) -> None:
        """Do nothing, because the stream is always UTF-8 and unbuffered."""

    def writable(self) -> bool:
        """Return True."""
        return True

    def readable(self) -> bool:
        """Return False."""
        return False

    def fileno(self) -> int:
        """Return 1 or 2, the descriptor of the stream in every program."""
        return 1 if self._stream == 'stdout' else 2


class BytesOutput:
    """`sys.stdout.buffer` of a simulated program; bytes are decoded as UTF-8."""

    def __init__(self, stream: OutputStream) -> None:
        self._stream = stream

    def write(self, data: bytes) -> int:
        """Write the bytes immediately, and return their number."""
        self._stream.write(bytes(data).decode('utf-8', 'replace'))
        return len(data)

    def flush(self) -> None:
        """Do nothing, because nothing is buffered."""


NAMES = ('stdin', 'stdout', 'stderr')


class SharedStream:
    """A stream of the real `sys` that forwards each call to the stream of the running program.

    Outside any program, and while a program's output is passed on, it forwards calls to the real stream.
    """

    def __init__(self, name: str, real: Any) -> None:
        self._name = name
        self._real = real

    def _here(self) -> Any:
        task = running_task()
        process = None if task is None or isinstance(task, AmbientTask) else task.owner
        return self._real if process is None or process.streams.is_writing else getattr(process.streams, self._name)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._here(), name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._here())


@contextmanager
def streams_of_programs() -> Iterator[None]:
    """Make output to the real `sys` go to the running program's own streams, while this context manager is active."""
    before = {name: getattr(sys, name) for name in NAMES}
    ours = {name: SharedStream(name, stream) for name, stream in before.items()}
    for name in NAMES:
        setattr(sys, name, ours[name])
    try:
        yield
    finally:
        for name in NAMES:
            if getattr(sys, name) is ours[name]:
                setattr(sys, name, before[name])


FIRST = 0x7F0000000010
MARK = ' at 0x'
"""A string without this has no address, so nothing else needs to be done with it."""
_ADDRESS = re.compile(r'(?<= at )0x[0-9a-f]{5,16}\b')


class Addresses:
    """The memory addresses that one program has written so far."""

    def __init__(self) -> None:
        self._shown: dict[str, str] = {}
        self._count = 0

    def steady(self, text: str) -> str:
        """Return a string in which addresses are replaced by numbered addresses. An address that is numbered already does not
        change.
        """
        return _ADDRESS.sub(lambda found: self._number(found[0]), text)

    def _number(self, address: str) -> str:
        shown = self._shown.get(address)
        if shown is None:
            shown = self._shown[address] = f'{FIRST + 16 * self._count:#x}'
            self._shown[shown] = shown
            self._count += 1
        return shown


class Streams:
    """The three standard streams of one program.

    :param stdin: the input of the program.
    :param write: called with the name of the stream and a string for each output.
    :ivar is_writing: whether the streams are passing output on. During this time, output to the real `sys` does not belong
        to the program.
    """

    def __init__(self, stdin: Any, write: Callable[[str, str], object]) -> None:
        self.stdin = stdin
        self.stdout = OutputStream(write, 'stdout')
        self.stderr = OutputStream(write, 'stderr')
        self.is_writing = False
        self._addresses = Addresses()

    def steady(self, text: str) -> str:
        """Return output of the program with everything replaced that differs from run to run, such as addresses of objects."""
        return self._addresses.steady(text) if MARK in text else text
