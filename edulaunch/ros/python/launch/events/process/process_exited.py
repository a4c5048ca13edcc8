"""The event `ProcessExited`."""

from __future__ import annotations

from typing import Any

from ..._bases import ReadOnly
from .running_process_event import RunningProcessEvent


class ProcessExited(RunningProcessEvent):
    """Emitted when a process has ended.

    :param returncode: the exit code; negative when a signal ended the process.
    """

    name = 'launch.events.process.ProcessExited'

    def __init__(self, *, returncode: int, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__returncode = returncode

    returncode: ReadOnly[int] = ReadOnly('The exit code.')
