"""The event handlers of a launch, in a table that calls the matchers of only those handlers that can match."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection
from typing import Any, Protocol

from .event import Event


class Handler(Protocol):
    """The part of an event handler that the table needs."""

    def matches(self, event: Event) -> bool:
        """Return whether the handler accepts the event."""

    def handle(self, event: Event, context: Any) -> Any:
        """Handle the event. Return the entities to visit, or None."""

    def describe(self) -> Any:
        """Return a description of the handler, and its entities."""


Ranked = dict[int, Handler]


class HandlerTable:
    """Registered handlers, each with a rank. The handler with the lowest rank is tried first."""

    def __init__(self) -> None:
        self._groups: dict[int, Ranked] = {0: {}}
        """Handlers by the `id()` of the only action whose events they accept; 0 means any action."""
        self._first = 0
        self._last = 0

    def as_deque(self) -> deque[Handler]:
        """Return all handlers in the order in which they are tried, in a deque as in upstream."""
        return deque(_in_order(*self._groups.values()))

    def add(self, handler: Handler, *, append: bool) -> None:
        """With `append`, add a handler after all other handlers. Otherwise, add it before all other handlers."""
        if append:
            self._last += 1
        else:
            self._first -= 1
        self._groups.setdefault(_key(handler), {})[self._last if append else self._first] = handler

    def remove(self, handler: Handler) -> None:
        """Remove a handler. If the handler was added more than once, remove only the entry that is tried first.

        :raises ValueError: when the handler is not registered.
        """
        key = _key(handler)
        group = self._groups.get(key, {})
        ranks = [rank for rank, other in group.items() if other is handler]
        if not ranks:
            raise ValueError(f'{handler!r} is not registered')
        del group[min(ranks)]
        if key and not group:
            del self._groups[key]

    def candidates(self, event: Event) -> list[Handler]:
        """Return the handlers that could accept the event, in the order in which they are tried."""
        return _in_order(*self._groups_for(event))

    def matches(self, event: Event) -> bool:
        """Return whether any handler matches the event. Launch calls this method for every executed action."""
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


def _in_order(*groups: Ranked) -> list[Handler]:
    ranked: Ranked = {}
    for group in groups:
        ranked.update(group)
    return [ranked[rank] for rank in sorted(ranked)]
