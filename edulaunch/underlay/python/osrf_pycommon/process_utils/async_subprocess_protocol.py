"""What hears from a program that an asyncio loop runs."""

from __future__ import annotations

import asyncio
import sys
from typing import Any


class AsyncSubprocessProtocol(asyncio.SubprocessProtocol):
    """Prints what the program prints; override the `on_...` methods to do something else.

    :ivar complete: a future, done with the return code when the program has ended and all its output has come.
    """

    def __init__(self, stdin: Any = None, stdout: Any = None, stderr: Any = None) -> None:
        self.stdin = stdin
        self.stdout = stdout
        self.stderr = stderr
        self.transport: Any = None
        self.complete: asyncio.Future[int] = asyncio.get_running_loop().create_future()

    def connection_made(self, transport: Any) -> None:
        """The program runs; `transport` can signal it."""
        self.transport = transport

    def pipe_data_received(self, fd: int, data: bytes) -> None:
        """The program wrote to its standard output (1) or standard error (2)."""
        if fd == 1:
            self.on_stdout_received(data)
        else:
            self.on_stderr_received(data)

    def on_stdout_received(self, data: bytes) -> None:
        """The program wrote to its standard output."""
        print(data.decode('utf-8', 'replace'), end='')

    def on_stderr_received(self, data: bytes) -> None:
        """The program wrote to its standard error."""
        print(data.decode('utf-8', 'replace'), end='', file=sys.stderr)

    def process_exited(self) -> None:
        """The program has ended; some of its output may not have come yet."""
        self.on_process_exited(self.transport.get_returncode())

    def connection_lost(self, exc: Exception | None) -> None:
        """The program has ended, and all its output has come."""
        if not self.complete.done():
            self.complete.set_result(self.transport.get_returncode())

    def on_process_exited(self, returncode: int) -> None:
        """The program has ended with this code."""
