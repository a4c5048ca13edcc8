"""The event `ShutdownProcess`."""

from __future__ import annotations

from .process_targeted_event import ProcessTargetedEvent


class ShutdownProcess(ProcessTargetedEvent):
    """Requests the end of processes. They receive SIGINT first. If they do not end, they receive SIGTERM and then SIGKILL."""

    name = 'launch.events.process.ShutdownProcess'
