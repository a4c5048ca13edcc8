"""The event `ShutdownProcess`."""

from __future__ import annotations

from .process_targeted_event import ProcessTargetedEvent


class ShutdownProcess(ProcessTargetedEvent):
    """Requests the end of processes: with SIGINT first, and with SIGTERM and SIGKILL if they do not end."""

    name = 'launch.events.process.ShutdownProcess'
