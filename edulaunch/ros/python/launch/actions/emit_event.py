"""The action `EmitEvent`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..action import Action
from ..event import Event
from ..utilities.type_utils import is_a_subclass

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class EmitEvent(Action):
    """Emit an event for the registered event handlers.

    :raises RuntimeError: when `event` is not an event.
    """

    def __init__(self, *, event: Event, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        if not is_a_subclass(event, Event):
            raise RuntimeError(f"EmitEvent() expected an event instance, got '{event}'.")
        self.__event = event

    event: ReadOnly[Event] = ReadOnly('The event.')

    def execute(self, context: LaunchContext) -> None:
        """Emit the event."""
        context.emit_event_sync(self.__event)
