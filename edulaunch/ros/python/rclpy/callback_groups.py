"""Groups that decide which callbacks of a node may run at the same time."""

from __future__ import annotations

from typing import Any


class CallbackGroup:
    """The base class of callback groups. It decides whether the callback of an entity may start.

    `busy_with` is the entity whose running callback blocks the others, if the group has one.
    """

    def __init__(self) -> None:
        self.entities: list[Any] = []
        self.busy_with: Any = None

    def add_entity(self, entity: Any) -> None:
        """Add an entity to the group."""
        self.entities.append(entity)

    def has_entity(self, entity: Any) -> bool:
        """Return whether an entity belongs to the group."""
        return entity in self.entities

    def can_execute(self, entity: Any) -> bool:
        """Return whether the entity's callback could start now."""
        raise TypeError('CallbackGroup is abstract; use MutuallyExclusiveCallbackGroup or ReentrantCallbackGroup')

    def beginning_execution(self, entity: Any) -> bool:
        """Start the entity's callback. Return False if it may not start."""
        return self.can_execute(entity)

    def ending_execution(self, entity: Any) -> None:
        """Record that the entity's callback has ended."""


class ReentrantCallbackGroup(CallbackGroup):
    """A group whose callbacks may all run at the same time."""

    def can_execute(self, entity: Any) -> bool:
        """Return True, because the callbacks may run at the same time."""
        return True


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """A group in which only one callback runs at a time. The default group of a node is such a group."""

    def can_execute(self, entity: Any) -> bool:
        """Return whether no other callback of the group is running."""
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
