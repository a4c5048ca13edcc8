"""The event `ShutdownProcess`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .process_targeted_event import ProcessTargetedEvent

if TYPE_CHECKING:
    pass


class ShutdownProcess(ProcessTargetedEvent):
    """Asks processes to end: SIGINT first, SIGTERM and SIGKILL when that does not help."""

    name = 'launch.events.process.ShutdownProcess'
