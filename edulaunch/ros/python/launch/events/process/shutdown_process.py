"""The event `ShutdownProcess`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .process_targeted_event import ProcessTargetedEvent

if TYPE_CHECKING:
    pass


class ShutdownProcess(ProcessTargetedEvent):
    """Requests the end of processes: with SIGINT first, and with SIGTERM and SIGKILL if they do not end."""

    name = 'launch.events.process.ShutdownProcess'
