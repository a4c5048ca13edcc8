"""The interface between a launch service and its observer. The dry run and the live view are observers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from ._engine import running_process


class Observer(Protocol):
    """An object that the launch service calls while it visits entities and handles events."""

    def enter(self, entity: Any, context: Any) -> None:
        """Report that the service begins to visit an entity. Entities entered before :meth:`leave` belong to this entity."""

    def instead_of(self, action: Any) -> Callable[[Any, Any], Any] | None:
        """Return the function to call in place of `action.execute`. It receives the action and the context.

        None means that the action is executed.
        """

    def executed(self, action: Any, context: Any) -> None:
        """Report that the condition of the action was true and that the action was executed."""

    def leads_to(self, entity: Any, entities: Any) -> None:
        """Report that the service is about to visit the entities that a visit has returned."""

    def leave(self, entity: Any, context: Any, error: Exception | None) -> None:
        """Report the end of a visit to the entity and to all entities that the visit returned."""

    def event(self, event: Any, context: Any) -> None:
        """Report that the service begins to process an event."""

    def ignores(self, handler: Any, event: Any) -> bool:
        """Return whether a handler must not handle an event that it matches."""

    def answered(self, handler: Any, event: Any, answer: Any) -> None:
        """Report that a handler has handled an event. The service visits the entities that the handler returned next."""

    def handled(self, handler: Any, event: Any) -> None:
        """Report that the entities returned by the handler have been visited."""

    def registered(self, handler: Any) -> None:
        """Report that an event handler was registered."""

    def unregistered(self, handler: Any) -> None:
        """Report that an event handler was unregistered."""


def observer_of_launch() -> Observer | None:
    """Return the observer for the launch service of the running process, or None if launch has no observer.

    The state of the process may contain an observer. Otherwise, the host of the machine creates one.
    """
    process = running_process()
    observer: Observer | None = process.state.get('launch.observer')
    if observer is None and process.host.make_launch_observer is not None:
        observer = process.state['launch.observer'] = process.host.make_launch_observer(process)
    return observer
