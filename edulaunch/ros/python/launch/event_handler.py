"""The base classes of event handlers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ._bases import ReadOnly, StableRepr
from .event import Event
from .launch_description_entity import SomeEntitiesType

if TYPE_CHECKING:
    from .launch_context import LaunchContext

Matcher = Callable[[Event], bool]


class BaseEventHandler(StableRepr):
    """A handler whose matcher decides which events it handles.

    :param matcher: a function that is called with each event, and returns whether the handler handles it.
    :param handle_once: whether to unregister this handler after the first event that it handles.
    """

    only_action: Any = None
    """The only action whose events the matcher can accept, or None for any action. Launch does not ask about events of other
    actions. Events without an action do not count. (edulaunch only.)
    """

    def __init__(self, *, matcher: Matcher, handle_once: bool = False) -> None:
        self.__matcher = matcher
        self.__handle_once = handle_once

    handle_once: ReadOnly[bool] = ReadOnly('Whether this handles only one event.')

    @property
    def handler_description(self) -> str:
        """A description of what the handler does."""
        return '<callable>'

    @property
    def matcher_description(self) -> str:
        """A description of the events that the handler handles."""
        return f'{self.__matcher}'

    def matches(self, event: Event) -> bool:
        """Return whether this handler handles the event."""
        return self.__matcher(event)

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description of the handler, and the entities that it visits, as far as they are known."""
        text = (
            f"{type(self).__name__}(matcher='{self.matcher_description}', "
            f"handler='{self.handler_description}', handle_once={self.__handle_once})"
        )
        return text, []

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Handle the event. Return entities to visit, or None. Subclasses extend this method."""
        context.extend_locals({'event': event})
        if self.__handle_once:
            context.unregister_event_handler(self)
        return None


class EventHandler(BaseEventHandler):
    """A handler that visits entities when an event matches.

    :param entities: one entity or several entities.
    """

    def __init__(self, *, matcher: Matcher, entities: SomeEntitiesType | None = None, handle_once: bool = False) -> None:
        super().__init__(matcher=matcher, handle_once=handle_once)
        self.__entities = entities

    entities: ReadOnly[SomeEntitiesType | None] = ReadOnly('The entities to visit.')

    @property
    def handler_description(self) -> str:
        """A description of what the handler does."""
        return '<entities>'

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """Return a description of the handler, and the entities that it visits."""
        text = super().describe()[0]
        if self.__entities is None:
            return text, []
        entities: Any = self.__entities
        return text, list(entities) if hasattr(entities, '__iter__') else [entities]

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """Return the entities."""
        super().handle(event, context)
        return self.__entities
