"""One run of a program as launch handles it. Its output and its end are reported on launch's own loop."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from .._engine import running_process

if TYPE_CHECKING:
    import asyncio

    from edulaunch.engine.processes import ProcessSpec


class ProcessRun:
    """A program that was started through the simulation's host.

    :param on_output: a function that is called on the loop as on_output('stdout' | 'stderr', text). Output that the program
        writes without a pause arrives in one call, as from a pipe.
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
        """The process ID."""
        pid: int = self._process.pid
        return pid

    def send_signal(self, signum: int) -> None:
        """Send a signal to the process."""
        self._process.send_signal(signum)

    def _take(self, stream: str, text: str) -> None:
        """Receive output of the program, which calls this method."""
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


class OutputLines:
    """Splits output that arrives in pieces into lines, and passes each complete line on.

    :param emit: a function that is called with each line, without its line end.
    :param cached: whether to store all output for :attr:`text`.
    """

    def __init__(self, emit: Callable[[str], object], cached: bool) -> None:
        self._emit = emit
        self._rest = ''
        self._pieces: list[str] | None = [] if cached else None

    @property
    def text(self) -> str:
        """The output so far."""
        return ''.join(self._pieces or ())

    def write(self, data: bytes) -> None:
        """Append the next part of the output. Invalid UTF-8 is replaced."""
        text = data.decode('utf-8', errors='replace')
        if self._pieces is not None:
            self._pieces.append(text)
        lines = (self._rest + text).split('\n')
        self._rest = lines.pop()
        for line in lines:
            self._emit(line)

    def flush(self) -> None:
        """Pass on the remaining incomplete line, if there is one."""
        rest, self._rest = self._rest, ''
        if rest:
            self._emit(rest)


DEFAULT_OUTPUT_FORMAT = '[{this.process_description.final_name}] {line}'


class ProcessOptions(NamedTuple):
    """The options of :class:`launch.actions.ExecuteLocal` for one process.

    Only `respawn` may contain substitutions before the action is prepared. As in upstream, the other options are used unchanged.
    """

    shell: Any = False
    emulate_tty: Any = False
    output_format: str = DEFAULT_OUTPUT_FORMAT
    cached_output: bool = False
    log_cmd: bool = False
    respawn: Any = False
    respawn_delay: Any = None
    respawn_max_retries: Any = -1

    def wants_respawn(self, retries: int) -> bool:
        """Return whether a process that has ended should be started again.

        :param retries: the number of restarts so far.
        :raises TypeError: when `respawn_max_retries` is not a number.
        """
        return bool(self.respawn) and (self.respawn_max_retries < 0 or retries < self.respawn_max_retries)

    @property
    def has_delay(self) -> bool:
        """Return whether the restart has a delay.

        :raises TypeError: when the delay is not a number.
        """
        return self.respawn_delay is not None and bool(self.respawn_delay > 0.0)
