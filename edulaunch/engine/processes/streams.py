"""What a simulated program writes to.

A student's own modules get the streams of their program from the `sys` view. Output of the standard library or an installed
package (warnings, `help()`, progress bars) goes through the real `sys`. While a simulation runs, this has a :class:`SharedStream`
in their place, so each call reaches the program that makes it.

Beginners print futures, nodes and methods (`<rclpy.task.Future object at 0x7f0000000010>`). The real addresses differ from run to
run, and recordings must not. So the addresses are replaced by numbers, in the order of their appearance.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from edulaunch.engine.sim.task import AmbientTask, running_task


class OutputStream:
    """`sys.stdout` or `sys.stderr` as a simulated program sees it.

    :param write: takes the name of the stream and a string.
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
        """Hand the text on at once."""
        if not isinstance(text, str):
            raise TypeError(f'write() argument must be str, not {type(text).__name__}')
        if text:
            self._write(self._stream, text)
        return len(text)

    def writelines(self, lines: list[str]) -> None:
        """Write all of them."""
        for line in lines:
            self.write(line)

    def flush(self) -> None:
        """Nothing is held back."""

    def isatty(self) -> bool:
        """Return a launched program writes to a pipe; one that was started in a terminal, to that."""
        return self.is_terminal

    @property
    def buffer(self) -> BytesOutput:
        """The stream for bytes."""
        return BytesOutput(self)

    def reconfigure(self, **_: object) -> None:
        """Everything is UTF-8 and goes out at once, whatever is asked for."""

    def writable(self) -> bool:
        """Yes."""
        return True

    def readable(self) -> bool:
        """No."""
        return False

    def fileno(self) -> int:
        """Return the number that the stream has in every program."""
        return 1 if self._stream == 'stdout' else 2


class BytesOutput:
    """`sys.stdout.buffer`: bytes are UTF-8 text."""

    def __init__(self, stream: OutputStream) -> None:
        self._stream = stream

    def write(self, data: bytes) -> int:
        """Hand the bytes on at once."""
        self._stream.write(bytes(data).decode('utf-8', 'replace'))
        return len(data)

    def flush(self) -> None:
        """Nothing is held back."""


NAMES = ('stdin', 'stdout', 'stderr')


class SharedStream:
    """The stream of that name of the program whose code runs; outside any program, and below its own output, the real one."""

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
    """Meanwhile what a program writes to the real `sys`, through modules that it shares with others, goes to its own streams."""
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
"""What to look for before anything else is done with a text."""
_ADDRESS = re.compile(r'(?<= at )0x[0-9a-f]{5,16}\b')


class Addresses:
    """What one program has written of addresses so far."""

    def __init__(self) -> None:
        self._shown: dict[str, str] = {}
        self._count = 0

    def steady(self, text: str) -> str:
        """Return the text with its addresses numbered; what has been numbered already stays as it is."""
        return _ADDRESS.sub(lambda found: self._number(found[0]), text)

    def _number(self, address: str) -> str:
        shown = self._shown.get(address)
        if shown is None:
            shown = self._shown[address] = f'{FIRST + 16 * self._count:#x}'
            self._shown[shown] = shown
            self._count += 1
        return shown


class Streams:
    """The three streams of one program.

    :param stdin: what the program reads.
    :param write: takes the output of the program: the name of the stream and a string.
    :ivar is_writing: its output is being handed on now; what is written meanwhile to the real `sys` is not the program's.
    """

    def __init__(self, stdin: Any, write: Callable[[str, str], object]) -> None:
        self.stdin = stdin
        self.stdout = OutputStream(write, 'stdout')
        self.stderr = OutputStream(write, 'stderr')
        self.is_writing = False
        self._addresses = Addresses()

    def steady(self, text: str) -> str:
        """Return output of the program without parts that differ from run to run, such as addresses of objects."""
        return self._addresses.steady(text) if MARK in text else text
