"""Seeing what launch visits, while launch itself does the visiting.

Each entity is wrapped; the wrapper visits it, tells the script what was executed, and hands launch the
sub-entities wrapped.
Event handlers are wrapped too, for what they return is visited later, in another phase.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.event_handler import BaseEventHandler
from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.event import Event
    from launch.launch_context import LaunchContext

Executed = Callable[[Any, 'LaunchContext'], object]

_PHASES = {
    'ProcessStarted': 'on_start',
    'TimerEvent': 'timer',
    'ProcessExited': 'on_exit',
    'Shutdown': 'on_shutdown',
}


class Watch:
    """What the wrappers share.

    :param executed: called as executed(action, context) after each action was executed.
    :param instead: by name of an action's class: what is done instead of executing such an action.
    :ivar phase: of what is visited now.
    """

    def __init__(self, executed: Executed, instead: dict[str, Callable[[Any, LaunchContext], Any]]) -> None:
        self.executed = executed
        self.instead = instead
        self.phase = 'launch'

    def entity(self, entity: Any) -> LaunchDescriptionEntity:
        """The entity, watched. (What is no entity stays, and fails in launch as it does without a watch.)"""
        return Watched(self, entity, self.phase) if isinstance(entity, LaunchDescriptionEntity) else entity

    def context(self, context: LaunchContext) -> None:
        """Watch what the handlers of a context return, from now on."""
        wrapped: dict[int, list[WatchedHandler]] = {}
        register, unregister = context.register_event_handler, context.unregister_event_handler

        def watched_register(event_handler: BaseEventHandler, append: bool = False) -> None:
            handler = WatchedHandler(self, event_handler)
            wrapped.setdefault(id(event_handler), []).append(handler)
            register(handler, append=append)

        def watched_unregister(event_handler: BaseEventHandler) -> None:
            handlers = wrapped.get(id(event_handler))
            unregister(handlers.pop() if handlers else event_handler)

        context.register_event_handler = watched_register  # type: ignore[method-assign]
        context.unregister_event_handler = watched_unregister  # type: ignore[method-assign]


class Watched(LaunchDescriptionEntity):
    """An entity whose visit is watched."""

    def __init__(self, watch: Watch, entity: LaunchDescriptionEntity, phase: str) -> None:
        self._watch = watch
        self._entity = entity
        self._phase = phase

    def visit(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Visit the entity."""
        self._watch.phase = self._phase
        if isinstance(self._entity, Action):
            entities = self._visit_action(self._entity, context)
        else:
            entities = self._entity.visit(context)
        return None if entities is None else [self._watch.entity(entity) for entity in entities]

    def _visit_action(self, action: Any, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        execute = self._watch.instead.get(type(action).__name__)

        def watched_execute(context: LaunchContext) -> Any:
            result = type(action).execute(action, context) if execute is None else execute(action, context)
            self._watch.executed(action, context)
            return result

        action.execute = watched_execute
        try:
            visited: Iterable[LaunchDescriptionEntity] | None = action.visit(context)
            return visited
        finally:
            del action.execute

    def get_asyncio_future(self) -> Any:
        """The entity's own."""
        return self._entity.get_asyncio_future()

    def describe(self) -> str:
        """The entity's own."""
        return self._entity.describe()


class WatchedHandler(BaseEventHandler):
    """A handler whose entities are watched, in the phase that belongs to the event."""

    def __init__(self, watch: Watch, handler: BaseEventHandler) -> None:
        super().__init__(matcher=handler.matches)
        self._watch = watch
        self._handler = handler

    def describe(self) -> Any:
        """The handler's own."""
        return self._handler.describe()

    def handle(self, event: Event, context: LaunchContext) -> Any:
        """Let the handler react; its entities come back watched."""
        self._watch.phase = _PHASES.get(type(event).__name__, self._watch.phase)
        entities = self._handler.handle(event, context)
        if entities is None:
            return None
        if isinstance(entities, LaunchDescriptionEntity):
            return self._watch.entity(entities)
        return [self._watch.entity(entity) for entity in entities]
