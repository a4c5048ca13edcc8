"""The event `ProcessIO`."""

from __future__ import annotations

from typing import Any

from ..._bases import ReadOnly
from .running_process_event import RunningProcessEvent


class ProcessIO(RunningProcessEvent):
    """Emitted when a process has written to one of its streams, or when it receives input.

    :param text: the bytes, which need not be whole lines.
    :param fd: 0 for stdin, 1 for stdout, 2 for stderr.
    """

    name = 'launch.events.process.ProcessIO'

    def __init__(self, *, text: bytes, fd: int, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__text = text
        self.__fd = fd

    text: ReadOnly[bytes] = ReadOnly('The bytes.')

    @property
    def from_stdin(self) -> bool:
        """Whether the bytes are input for the process."""
        return self.__fd == 0

    @property
    def from_stdout(self) -> bool:
        """Whether the bytes come from standard output."""
        return self.__fd == 1

    @property
    def from_stderr(self) -> bool:
        """Whether the bytes come from standard error."""
        return self.__fd == 2
