"""Reacting to events."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Any

from ._bases import ReadOnly, StableRepr
from .event import Event
from .launch_description_entity import SomeEntitiesType

if TYPE_CHECKING:
    from .launch_context import LaunchContext

Matcher = Callable[[Event], bool]


class BaseEventHandler(StableRepr):
    """Decides by its matcher whether it handles an event.

    :param matcher: called with each event.
    :param handle_once: forget this handler after the first event.
    """

    only_action: Any = None
    """The only action whose events the matcher can accept, None when it can be any; events that have no action do not count.

    Launch then does not ask about others. (edulaunch only.)
    """

    def __init__(self, *, matcher: Matcher, handle_once: bool = False) -> None:
        self.__matcher = matcher
        self.__handle_once = handle_once

    handle_once: ReadOnly[bool] = ReadOnly('Whether this handles only one event.')

    @property
    def handler_description(self) -> str:
        """What the handler does, in words."""
        return '<callable>'

    @property
    def matcher_description(self) -> str:
        """Which events are handled, in words."""
        return f'{self.__matcher}'

    def matches(self, event: Event) -> bool:
        """Whether this handles the event."""
        return self.__matcher(event)

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """The handler in words, and the entities it is known to lead to."""
        text = (
            f"{type(self).__name__}(matcher='{self.matcher_description}', "
            f"handler='{self.handler_description}', handle_once={self.__handle_once})"
        )
        return text, []

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """React; returns entities to visit, or None. To be extended by subclasses."""
        context.extend_locals({'event': event})
        if self.__handle_once:
            context.unregister_event_handler(self)
        return None


class EventHandler(BaseEventHandler):
    """Visits entities when an event matches.

    :param entities: an entity or several.
    """

    def __init__(self, *, matcher: Matcher, entities: SomeEntitiesType | None = None, handle_once: bool = False) -> None:
        super().__init__(matcher=matcher, handle_once=handle_once)
        self.__entities = entities

    entities: ReadOnly[SomeEntitiesType | None] = ReadOnly('What is visited.')

    @property
    def handler_description(self) -> str:
        """What the handler does, in words."""
        return '<entities>'

    def describe(self) -> tuple[str, list[SomeEntitiesType]]:
        """The handler in words, and its entities."""
        text = super().describe()[0]
        if self.__entities is None:
            return text, []
        entities: Any = self.__entities
        return text, list(entities) if hasattr(entities, '__iter__') else [entities]

    def handle(self, event: Event, context: LaunchContext) -> SomeEntitiesType | None:
        """The entities."""
        super().handle(event, context)
        return self.__entities


Ranked = dict[int, BaseEventHandler]


class HandlerTable:
    """Registered handlers, each with a rank; the lowest rank is asked first."""

    def __init__(self) -> None:
        self._groups: dict[int, Ranked] = {0: {}}
        """By the identity of the only action whose events they accept; 0: any."""
        self._first = 0
        self._last = 0

    def as_deque(self) -> deque[BaseEventHandler]:
        """All handlers, first asked first; what upstream keeps."""
        return deque(_in_order(*self._groups.values()))

    def add(self, handler: BaseEventHandler, *, append: bool) -> None:
        """Let the handler be asked first, or last."""
        if append:
            self._last += 1
        else:
            self._first -= 1
        self._groups.setdefault(_key(handler), {})[self._last if append else self._first] = handler

    def remove(self, handler: BaseEventHandler) -> None:
        """Forget the handler (once, if it was added more often).

        :raises ValueError: when it is not there.
        """
        key = _key(handler)
        group = self._groups.get(key, {})
        ranks = [rank for rank, other in group.items() if other is handler]
        if not ranks:
            raise ValueError(f'{handler!r} is not registered')
        del group[min(ranks)]
        if key and not group:
            del self._groups[key]

    def candidates(self, event: Event) -> list[BaseEventHandler]:
        """The handlers that could accept the event, first asked first."""
        return _in_order(*self._groups_for(event))

    def matches(self, event: Event) -> bool:
        """Whether any handler matches the event; every action that was executed asks."""
        for group in self._groups_for(event):
            for handler in list(group.values()):
                if handler.matches(event):
                    return True
        return False

    def _groups_for(self, event: Event) -> Collection[Ranked]:
        action = getattr(event, 'action', None)
        if action is None:
            return self._groups.values()
        return self._groups[0], self._groups.get(id(action), {})


def _key(handler: Any) -> int:
    only = getattr(handler, 'only_action', None)
    return 0 if only is None else id(only)


def _in_order(*groups: Ranked) -> list[BaseEventHandler]:
    ranked: Ranked = {}
    for group in groups:
        ranked.update(group)
    return [ranked[rank] for rank in sorted(ranked)]
