"""Seeing what launch visits, while launch itself does the visiting.

Each entity is wrapped; the wrapper visits it, tells the script what was executed, and hands launch the
sub-entities wrapped.
Event handlers are wrapped too, for what they return is visited later, in another phase.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from launch._handler_table import Handler
from launch.action import Action
from launch.event_handler import BaseEventHandler
from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.launch_description_entity import LaunchDescriptionEntity

from edulaunch.advice.plan.rehearsal import MOST_REACTIONS
from edulaunch.advice.plan.wording import Branch
from edulaunch.engine.underlay_place import is_students

if TYPE_CHECKING:
    from launch.event import Event
    from launch.launch_context import LaunchContext

_is_students = lru_cache(maxsize=256)(is_students)
Executed = Callable[[Branch, 'LaunchContext'], object]

_PHASES = {'ProcessStarted': 'on_start', 'TimerEvent': 'timer', 'ProcessExited': 'on_exit', 'Shutdown': 'on_shutdown'}
_EVENTS = {'ProcessStarted': 'when {name} has started', 'ProcessExited': 'when {name} has ended', 'Shutdown': 'at shutdown'}
_NO_BRANCH = ('IncludeLaunchDescription', 'TimerEvent')
"""What follows these events hangs below the action itself."""


class Watch:
    """What the wrappers share.

    :param executed: called as executed(branch, context) after each action was executed.
    :param instead: by name of an action's class: what is done instead of executing such an action.
    :param came_back: numbers of processes that were started again; what follows their start and end is planned already.
    :ivar phase: of what is visited now.
    :ivar outline: everything so far.
    :ivar timers: the branch of each timer that was set: launch has one handler for them all.
    :ivar reactions: how often handlers gave actions; beyond the most that may be they stay silent, so that the launch ends.
    """

    def __init__(
        self, executed: Executed, instead: dict[str, Callable[[Any, LaunchContext], Any]], came_back: Collection[int]
    ) -> None:
        self.executed = executed
        self.instead = instead
        self.came_back = came_back
        self.phase = 'launch'
        self.outline = Branch('')
        self.branch = self.outline
        self.timers: dict[Any, Branch] = {}
        self.reactions = 0

    @property
    def is_endless(self) -> bool:
        """Whether the handlers were silenced."""
        return self.reactions > MOST_REACTIONS

    def entity(self, entity: Any, parent: Branch | None = None) -> LaunchDescriptionEntity:
        """The entity, watched. (What is no entity stays, and fails in launch as it does without a watch.)"""
        if not isinstance(entity, LaunchDescriptionEntity):
            return entity  # type: ignore[no-any-return]
        return Watched(self, entity, self.phase, self.outline if parent is None else parent)

    def context(self, context: LaunchContext) -> None:
        """Watch what the handlers of a context return, from now on."""
        wrapped: dict[int, list[WatchedHandler]] = {}
        register, unregister = context.register_event_handler, context.unregister_event_handler

        def watched_register(event_handler: Handler, append: bool = False) -> None:
            handler = WatchedHandler(self, event_handler, self.branch)
            wrapped.setdefault(id(event_handler), []).append(handler)
            register(handler, append=append)

        def watched_unregister(event_handler: Handler) -> None:
            handlers = wrapped.get(id(event_handler))
            unregister(handlers.pop() if handlers else event_handler)

        context.register_event_handler = watched_register  # type: ignore[method-assign]
        context.unregister_event_handler = watched_unregister  # type: ignore[method-assign]


class Watched(LaunchDescriptionEntity):
    """An entity whose visit is watched."""

    def __init__(self, watch: Watch, entity: LaunchDescriptionEntity, phase: str, parent: Branch) -> None:
        self._watch = watch
        self._entity = entity
        self._phase = phase
        self._branch = parent

    def visit(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Visit the entity."""
        watch = self._watch
        watch.phase = self._phase
        if isinstance(self._entity, Action):
            action: Any = self._entity
            condition = None if action.condition is None else action.condition.in_words
            origin = action.origin
            if origin is not None and not _is_students(origin.file):
                origin = None
            self._branch = watch.branch = self._branch.add(Branch(action, origin, condition))
            if hasattr(action, 'period'):
                watch.timers[action] = self._branch
            entities = self._visit_action(action, context)
        else:
            entities = self._entity.visit(context)
        # One by one: a function may add actions to the very description that is visited.
        return None if entities is None else (watch.entity(entity, self._branch) for entity in entities)

    def _visit_action(self, action: Any, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        execute = self._watch.instead.get(type(action).__name__)

        def watched_execute(context: LaunchContext) -> Any:
            result = type(action).execute(action, context) if execute is None else execute(action, context)
            self._branch.is_taken = True
            self._watch.executed(self._branch, context)
            return result

        action.execute = watched_execute
        try:
            visited: Iterable[LaunchDescriptionEntity] | None = action.visit(context)
            return visited
        except Exception:
            self._branch.condition = None
            raise
        finally:
            del action.execute

    def get_asyncio_future(self) -> Any:
        """The entity's own."""
        return self._entity.get_asyncio_future()

    def describe(self) -> str:
        """The entity's own."""
        return self._entity.describe()


class WatchedHandler(BaseEventHandler):
    """A handler whose entities are watched, in the phase that belongs to the event.

    :param parent: the branch of the action that registered it.
    """

    def __init__(self, watch: Watch, handler: Handler, parent: Branch) -> None:
        super().__init__(matcher=handler.matches)
        self.only_action = getattr(handler, 'only_action', None)
        self._watch = watch
        self._handler = handler
        self._parent = parent

    def describe(self) -> Any:
        """The handler's own."""
        return self._handler.describe()

    def handle(self, event: Event, context: LaunchContext) -> Any:
        """Let the handler react; its entities come back watched."""
        watch, kind = self._watch, type(event).__name__
        is_known = isinstance(self._handler, OnActionEventBase) and getattr(event, 'pid', None) in watch.came_back
        if watch.is_endless or is_known:
            return None
        watch.phase = _PHASES.get(kind, watch.phase)
        entities = self._handler.handle(event, context)
        if entities is None:
            return None
        listed = [entities] if isinstance(entities, LaunchDescriptionEntity) else list(entities)
        watch.reactions += bool(listed)
        parent = watch.timers.get(getattr(event, 'timer_action', None), self._parent)
        if kind not in _NO_BRANCH and listed:
            text = _EVENTS.get(kind, f'on {event.name}').format(name=getattr(event, 'process_name', ''))
            parent = parent.add(Branch(text))
            parent.is_taken = True
        return [watch.entity(entity, parent) for entity in listed]
