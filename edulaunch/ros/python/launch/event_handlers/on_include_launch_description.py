"""The event handler `OnIncludeLaunchDescription`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..event import Event
from ..event_handler import BaseEventHandler
from ..events.include_launch_description import IncludeLaunchDescription
from ..launch_description_entity import SomeEntitiesType

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class OnIncludeLaunchDescription(BaseEventHandler):
    """Visits the description of each `IncludeLaunchDescription` event. Each launch service has one such handler."""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, IncludeLaunchDescription), **kwargs)

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the launch description of the event."""
        super().handle(event, context)
        assert isinstance(event, IncludeLaunchDescription)
        return event.launch_description

    @property
    def handler_description(self) -> str:
        """A description of what the handler does."""
        return 'returns the launch_description in the event'

    @property
    def matcher_description(self) -> str:
        """A description of the events that the handler handles."""
        return 'event issubclass of launch.events.IncludeLaunchDescription'
