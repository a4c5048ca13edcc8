"""Groups that decide which callbacks of a node may run at the same time."""

from __future__ import annotations

from typing import Any
from weakref import ref


class CallbackGroup:
    """The base class of callback groups. A group decides whether the callback of an entity may start.

    `busy_with` is the entity whose running callback blocks all other callbacks of the group, or None.
    """

    def __init__(self) -> None:
        self.entities: set[ref[Any]] = set()
        self.busy_with: Any = None

    def add_entity(self, entity: Any) -> None:
        """Add an entity to the group."""
        self.entities.add(ref(entity, self.entities.discard))

    def has_entity(self, entity: Any) -> bool:
        """Return whether an entity belongs to the group."""
        return ref(entity) in self.entities

    def can_execute(self, entity: Any) -> bool:
        """Return whether the entity's callback could start now. Subclasses must implement this method."""
        raise NotImplementedError()

    def beginning_execution(self, entity: Any) -> bool:
        """Mark the entity's callback as running. Return False if the callback must not start."""
        return self.can_execute(entity)

    def ending_execution(self, entity: Any) -> None:
        """Record that the entity's callback has ended. Subclasses must implement this method."""
        raise NotImplementedError()


class ReentrantCallbackGroup(CallbackGroup):
    """A group whose callbacks may all run at the same time."""

    def can_execute(self, entity: Any) -> bool:
        """Return True, because the callbacks may run at the same time."""
        return True

    def ending_execution(self, entity: Any) -> None:
        """Record that the entity's callback has ended, which has no effect here."""


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """A group in which only one callback runs at a time. The default group of a node is such a group."""

    def can_execute(self, entity: Any) -> bool:
        """Return whether no other callback of the group is running. Raise AssertionError for an entity of another group."""
        assert ref(entity) in self.entities
        return self.busy_with is None

    def beginning_execution(self, entity: Any) -> bool:
        """Reserve the group for one callback, and return True. Return False if the group is busy. Raise AssertionError for an
        entity of another group.
        """
        assert ref(entity) in self.entities
        if self.busy_with is not None:
            return False
        self.busy_with = entity
        return True

    def ending_execution(self, entity: Any) -> None:
        """Free the group for the next callback. Raise AssertionError unless this entity's callback was running."""
        assert self.busy_with is entity
        self.busy_with = None
