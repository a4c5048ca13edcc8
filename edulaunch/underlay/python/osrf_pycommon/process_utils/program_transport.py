"""A program that a simulated asyncio loop runs."""

from __future__ import annotations

import asyncio
import signal
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.processes.host import Host
    from edulaunch.processes.spec import ProcessSpec


class ProgramTransport(asyncio.SubprocessTransport):
    """Starts the program and tells its protocol everything, on the loop. It has no pipes to write to.

    :param stderr_to_stdout: tell of both streams as of standard output.
    :raises FileNotFoundError: when there is no such command.
    """

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        protocol: asyncio.SubprocessProtocol,
        host: Host,
        spec: ProcessSpec,
        stderr_to_stdout: bool,
    ) -> None:
        super().__init__()
        self._loop = loop
        self._protocol = protocol
        self._fds = {'stdout': 1, 'stderr': 1 if stderr_to_stdout else 2}
        self._program = host.start(spec, on_output=self._on_output, on_exit=self._on_exit)
        protocol.connection_made(self)

    def _on_output(self, stream: str, text: str) -> None:
        self._loop.call_soon_threadsafe(self._protocol.pipe_data_received, self._fds[stream], text.encode())

    def _on_exit(self, returncode: int) -> None:
        self._loop.call_soon_threadsafe(self._protocol.process_exited)
        self._loop.call_soon_threadsafe(self._protocol.connection_lost, None)

    def get_pid(self) -> int:
        """The number of the program."""
        return self._program.pid

    def get_returncode(self) -> int | None:
        """The code it ended with, None before."""
        return self._program.returncode

    def get_pipe_transport(self, fd: int) -> Any:
        """None: nothing can be written to it."""
        return None

    def send_signal(self, signal: int) -> None:
        """Send it a signal."""
        self._program.send_signal(signal)

    def terminate(self) -> None:
        """Send it SIGTERM."""
        self.send_signal(signal.SIGTERM)

    def kill(self) -> None:
        """Send it SIGKILL."""
        self.send_signal(signal.SIGKILL)

    def close(self) -> None:
        """End it, if it still runs."""
        if self.get_returncode() is None:
            self.kill()

    def is_closing(self) -> bool:
        """Whether it has ended."""
        return self.get_returncode() is not None
