"""The event handler `OnShutdown`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..event import Event
from ..event_handler import BaseEventHandler
from ..events.shutdown import Shutdown
from ..launch_description_entity import SomeEntitiesType

if TYPE_CHECKING:
    from ..launch_context import LaunchContext

    ShutdownReaction = SomeEntitiesType | Callable[[Shutdown, LaunchContext], SomeEntitiesType | None]


class OnShutdown(BaseEventHandler):
    """Handles a request to end the launch.

    :param on_shutdown: one or more entities, or a callable (event, context) that may return entities.
    """

    def __init__(self, *, on_shutdown: ShutdownReaction, **kwargs: Any) -> None:
        super().__init__(matcher=lambda event: isinstance(event, Shutdown), **kwargs)
        self.__on_shutdown: Any = on_shutdown

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities, or the result of the callable."""
        super().handle(event, context)
        answer: SomeEntitiesType | None = (
            self.__on_shutdown(event, context) if callable(self.__on_shutdown) else self.__on_shutdown
        )
        return answer

    @property
    def handler_description(self) -> str:
        """A description of the callable, or of the entities."""
        return str(self.__on_shutdown)

    @property
    def matcher_description(self) -> str:
        """A description of the events that the handler handles."""
        return 'event issubclass of launch.events.Shutdown'

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description of the handler, and the entities that it visits."""
        text = super().describe()[0]
        if callable(self.__on_shutdown):
            return text, []
        entities = self.__on_shutdown
        return text, list(entities) if hasattr(entities, '__iter__') else [entities]
