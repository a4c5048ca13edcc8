"""The interface between a launch service and its observer. The dry run and the live view are observers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from ._engine import running_process


class Observer(Protocol):
    """An object that the launch service calls while it visits entities and handles events."""

    def enter(self, entity: Any, context: Any) -> None:
        """The service begins to visit an entity. Entities that are entered before :meth:`leave` belong to it."""

    def instead_of(self, action: Any) -> Callable[[Any, Any], Any] | None:
        """Return the function to call in place of `action.execute`, with the action and the context. None executes the action."""

    def executed(self, action: Any, context: Any) -> None:
        """The condition of the action held, and the action was executed."""

    def leads_to(self, entity: Any, entities: Any) -> None:
        """The service is about to visit the entities that a visit has returned."""

    def leave(self, entity: Any, context: Any, error: Exception | None) -> None:
        """The visit of the entity, and of everything that it led to, is over."""

    def event(self, event: Any, context: Any) -> None:
        """The service begins to process an event."""

    def ignores(self, handler: Any, event: Any) -> bool:
        """Return whether a handler that matches an event must not handle it."""

    def answered(self, handler: Any, event: Any, answer: Any) -> None:
        """A handler has handled an event; the service visits the answer next."""

    def handled(self, handler: Any, event: Any) -> None:
        """The answer has been visited."""

    def registered(self, handler: Any) -> None:
        """An event handler was registered."""

    def unregistered(self, handler: Any) -> None:
        """An event handler was unregistered."""


def observer_of_launch() -> Observer | None:
    """Return the observer for the launch service of the running process, or None.

    The state of the process may contain one. Otherwise the host of the machine makes it.
    """
    process = running_process()
    observer: Observer | None = process.state.get('launch.observer')
    if observer is None and process.host.make_launch_observer is not None:
        observer = process.state['launch.observer'] = process.host.make_launch_observer(process)
    return observer
