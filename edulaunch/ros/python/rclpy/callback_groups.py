"""Which callbacks of a node may run at the same time."""

from __future__ import annotations

from typing import Any


class CallbackGroup:
    """Base of callback groups: decides whether the callback of an entity may begin.

    `busy_with` is the entity whose callback runs now, where that shuts out others.
    """

    def __init__(self) -> None:
        self.entities: list[Any] = []
        self.busy_with: Any = None

    def add_entity(self, entity: Any) -> None:
        """Count an entity as a member."""
        self.entities.append(entity)

    def has_entity(self, entity: Any) -> bool:
        """Return whether an entity is a member."""
        return entity in self.entities

    def can_execute(self, entity: Any) -> bool:
        """Return whether the entity's callback could begin now."""
        raise TypeError('CallbackGroup is abstract; use MutuallyExclusiveCallbackGroup or ReentrantCallbackGroup')

    def beginning_execution(self, entity: Any) -> bool:
        """Let the entity's callback begin; False when it may not."""
        return self.can_execute(entity)

    def ending_execution(self, entity: Any) -> None:
        """The entity's callback has ended."""


class ReentrantCallbackGroup(CallbackGroup):
    """Callbacks run in any number at the same time."""

    def can_execute(self, entity: Any) -> bool:
        """True: nothing keeps its callbacks apart."""
        return True


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """One callback at a time. The default group of a node is one of these."""

    def can_execute(self, entity: Any) -> bool:
        """When no other callback of the group runs."""
        return self.busy_with is None

    def beginning_execution(self, entity: Any) -> bool:
        """Reserve the group for one callback, if it is free."""
        if self.busy_with is not None:
            return False
        self.busy_with = entity
        return True

    def ending_execution(self, entity: Any) -> None:
        """Free the group for the next callback."""
        self.busy_with = None
