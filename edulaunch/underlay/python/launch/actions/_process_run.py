"""One run of a program, from launch's side: what it prints and how it ends arrive on launch's own loop."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .._engine import running_process

if TYPE_CHECKING:
    from edulaunch.processes import ProcessSpec


class ProcessRun:
    """A program that was started through the simulation's host.

    :param on_output: called on the loop as on_output('stdout' | 'stderr', text). Pieces that were written
        without a pause arrive as one, as they would from a pipe.
    :raises OSError: when the program cannot be started.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop, spec: ProcessSpec, on_output: Callable[[str, str], object]) -> None:
        self._loop = loop
        self._on_output = on_output
        self._pending: list[tuple[str, str]] = []
        self.complete: asyncio.Future[int] = loop.create_future()
        self._process: Any = running_process().host.start_launched(spec, self._take, self._end)

    @property
    def pid(self) -> int:
        """The process number."""
        pid: int = self._process.pid
        return pid

    def send_signal(self, signum: int) -> None:
        """Send a signal."""
        self._process.send_signal(signum)

    def _take(self, stream: str, text: str) -> None:
        """Called by the program, on its own turn."""
        if self._loop.is_closed():
            return
        self._pending.append((stream, text))
        if len(self._pending) == 1:
            self._loop.call_soon_threadsafe(self._deliver)

    def _deliver(self) -> None:
        pending, self._pending = self._pending, []
        start = 0
        for position, (stream, _) in enumerate(pending):
            if position + 1 == len(pending) or pending[position + 1][0] != stream:
                self._on_output(stream, ''.join([text for _, text in pending[start : position + 1]]))
                start = position + 1

    def _end(self, returncode: int) -> None:
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._complete, returncode)

    def _complete(self, returncode: int) -> None:
        if not self.complete.done():
            self.complete.set_result(returncode)
