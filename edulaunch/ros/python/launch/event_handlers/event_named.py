"""A matcher of events by name."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from ..event import Event

if TYPE_CHECKING:
    pass


def event_named(name: str) -> Callable[[Event], bool]:
    """Return a matcher for events with this `name`, such as 'launch.events.Shutdown'."""
    return lambda event: event.name == name
