"""What a simulated program writes to."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class OutputStream:
    """`sys.stdout` or `sys.stderr` as a simulated program sees it."""

    encoding = 'utf-8'
    errors = 'replace'
    closed = False
    newlines = None
    line_buffering = True
    is_terminal = False

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
        """A launched program writes to a pipe; one that was started in a terminal, to that."""
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
