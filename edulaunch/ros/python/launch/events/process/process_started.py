"""The event `ProcessStarted`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .running_process_event import RunningProcessEvent

if TYPE_CHECKING:
    pass


class ProcessStarted(RunningProcessEvent):
    """Emitted when a process has been started."""

    name = 'launch.events.process.ProcessStarted'
