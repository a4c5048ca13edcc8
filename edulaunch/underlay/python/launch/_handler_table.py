"""The event handlers of a context, found quickly.

Upstream asks every handler about every event. Each process brings six handlers, so a hundred processes would
cost six hundred questions for each line that one of them prints. Handlers that say which types of events, and
events of which action, they can accept are therefore kept in groups by these; only the groups that can match
are asked, in the same order as upstream.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from typing import Any

from .event import Event
from .event_handler import BaseEventHandler

Key = tuple[Any, int]
"""Event type (None: any) and id of the action (0: any)."""
Ranked = dict[int, BaseEventHandler]
_ANY: Sequence[tuple[type | None, Any]] = ((None, None),)


class HandlerTable:
    """Registered handlers, each with a rank; the lowest rank is asked first."""

    def __init__(self) -> None:
        self._ranks: dict[int, list[int]] = {}
        self._groups: dict[Key, Ranked] = {}
        self._types: dict[type | None, int] = {}
        self._known_answers: dict[type, bool] = {}
        self._first = 0
        self._last = 0

    def __iter__(self) -> Iterator[BaseEventHandler]:
        ranked: Ranked = {}
        for group in self._groups.values():
            ranked.update(group)
        return (ranked[rank] for rank in sorted(ranked))

    def as_deque(self) -> deque[BaseEventHandler]:
        """All handlers, first asked first; what upstream keeps."""
        return deque(self)

    def add(self, handler: BaseEventHandler, *, append: bool) -> None:
        """Let the handler be asked first, or last."""
        if append:
            self._last += 1
            rank = self._last
        else:
            self._first -= 1
            rank = self._first
        self._ranks.setdefault(id(handler), []).append(rank)
        groups = self._groups
        for event_type, action in getattr(handler, '_event_keys', None) or _ANY:
            key = event_type, id(action) if action is not None else 0
            group = groups.get(key)
            if group is None:
                groups[key] = {rank: handler}
                known = self._types.get(event_type, 0)
                self._types[event_type] = known + 1
                if not known:
                    self._known_answers.clear()
            else:
                group[rank] = handler

    def remove(self, handler: BaseEventHandler) -> None:
        """Forget the handler (once, if it was added more often).

        :raises ValueError: when it is not there.
        """
        ranks = self._ranks.get(id(handler))
        if not ranks:
            raise ValueError(f'{handler!r} is not registered')
        rank = min(ranks)
        ranks.remove(rank)
        if not ranks:
            del self._ranks[id(handler)]
        for event_type, action in getattr(handler, '_event_keys', None) or _ANY:
            key = event_type, id(action) if action is not None else 0
            group = self._groups[key]
            del group[rank]
            if not group:
                del self._groups[key]
                self._types[event_type] -= 1
                if not self._types[event_type]:
                    self._known_answers.clear()

    def may_handle(self, event_type: type) -> bool:
        """Whether any handler could accept an event of this type. Quick; True is no promise."""
        answer = self._known_answers.get(event_type)
        if answer is None:
            types = self._types
            answer = bool(types.get(None)) or any(types.get(base) for base in event_type.__mro__)
            self._known_answers[event_type] = answer
        return answer

    def candidates(self, event: Event) -> list[BaseEventHandler]:
        """The handlers that could accept the event, first asked first."""
        groups = self._groups
        action = getattr(event, 'action', None)
        found = [groups[(None, 0)]] if (None, 0) in groups else []
        for event_type in type(event).__mro__:
            for key in ((event_type, 0), (event_type, id(action))):
                group = groups.get(key)
                if group is not None:
                    found.append(group)
        if not found:
            return []
        if len(found) == 1:
            ranked = found[0]
        else:
            ranked = {}
            for group in found:
                ranked.update(group)
        return [ranked[rank] for rank in sorted(ranked)]
