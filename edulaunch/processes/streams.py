"""What a simulated program writes to and reads from."""
from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.processes.process import Process
    from edulaunch.processes.watchdog import Watchdog


class OutputStream:
    """`sys.stdout` or `sys.stderr` as a simulated program sees it."""

    encoding = 'utf-8'
    errors = 'replace'
    closed = False
    newlines = None
    line_buffering = True

    def __init__(self, process: Process, name: str) -> None:
        self._process = process
        self._stream = name
        self.name = f'<{name}>'

    def write(self, text: str) -> int:
        """Hand the text on at once."""
        if not isinstance(text, str):
            raise TypeError(f'write() argument must be str, not {type(text).__name__}')
        if text:
            self._process.write(self._stream, text)
        return len(text)

    def writelines(self, lines: list[str]) -> None:
        """Write all of them."""
        for line in lines:
            self.write(line)

    def flush(self) -> None:
        """Nothing is held back."""

    def isatty(self) -> bool:
        """A launched program writes to a pipe."""
        return False

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
        """The number that the stream has in every program."""
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


class ScriptedInput(io.StringIO):
    """`sys.stdin` of a simulated program: the given text, then the end of the file.

    A program that reads key by key (see the `termios` view) has a keyboard instead: nobody presses a key after the last one.

    :ivar by_key: whether the program took the terminal out of its line mode.
    """

    name = '<stdin>'
    by_key = False

    def isatty(self) -> bool:
        """A launched program reads no terminal."""
        return False

    def fileno(self) -> int:
        """The number that it has in every program."""
        return 0

    def is_ready(self) -> bool:
        """Whether reading would not have to wait."""
        return not self.by_key or self.tell() < len(self.getvalue())

    def wait_for_ever(self) -> None:
        """Let the program wait until a signal ends it."""
        while True:
            current_task().park()

    def read(self, size: int | None = -1, /) -> str:
        """As any text file; at the end of a keyboard's keys it waits."""
        return self._told(super().read(size))

    def readline(self, size: int = -1, /) -> str:  # type: ignore[override]
        """As any text file; at the end of a keyboard's keys it waits."""
        return self._told(super().readline(size))

    def _told(self, text: str) -> str:
        if not text:
            if self.by_key:
                self.wait_for_ever()
            current_task().poll()  # a loop that reads on and on must not stop the time
        return text


class RealInput:
    """An open text file as `sys.stdin` of a simulated program: the whole simulation waits while somebody types.

    :param file: a terminal, a pipe or a file of this machine.
    :param watchdog: told to be patient meanwhile.
    """

    by_key = False

    def __init__(self, file: Any, watchdog: Watchdog | None) -> None:
        self._file = file
        self._watchdog = watchdog

    def __getattr__(self, name: str) -> Any:
        return getattr(self._file, name)

    def __iter__(self) -> Iterator[str]:
        return iter(self.readline, '')

    def is_ready(self) -> bool:
        """Whether reading would not have to wait."""
        import select
        return bool(select.select([self._file], [], [], 0)[0])

    def read(self, size: int = -1) -> str:
        """As the file's."""
        return self._patiently(self._file.read, size)

    def readline(self) -> str:
        """As the file's."""
        return self._patiently(self._file.readline)

    def _patiently(self, read: Callable[..., str], *arguments: int) -> str:
        if self._watchdog is None:
            return read(*arguments)
        self._watchdog.asleep = True
        try:
            return read(*arguments)
        finally:
            self._watchdog.asleep = False
