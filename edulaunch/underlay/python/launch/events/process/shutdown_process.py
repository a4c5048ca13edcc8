"""A process is to end."""

from __future__ import annotations

from .process_targeted_event import ProcessTargetedEvent


class ShutdownProcess(ProcessTargetedEvent):
    """Asks processes to end: SIGINT first, SIGTERM and SIGKILL when that does not help."""

    name = 'launch.events.process.ShutdownProcess'
