"""An observer that builds the outline of the actions that a launch service visits, with the phase of each action.

The dry run uses this observer directly. The trace of a running launch (`launch_trace.py`) extends it.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.event_handlers.on_action_event_base import OnActionEventBase
from launch.launch_description_entity import LaunchDescriptionEntity

from edulaunch.advice.plan.titles import Branch
from edulaunch.engine.underlay_place import is_students

if TYPE_CHECKING:
    from launch.event import Event
    from launch.launch_context import LaunchContext

    from edulaunch.engine.processes import Origin

_is_students = lru_cache(maxsize=256)(is_students)
Executed = Callable[[Branch, 'LaunchContext'], object]

_PHASES = {'ProcessStarted': 'on_start', 'TimerEvent': 'timer', 'ProcessExited': 'on_exit', 'Shutdown': 'on_shutdown'}
_EVENTS = {'ProcessStarted': 'when {name} has started', 'ProcessExited': 'when {name} has ended', 'Shutdown': 'at shutdown'}
MOST_REACTIONS = 20_000
"""How often event handlers may return actions. Launch handles events that follow from events in one step."""
_NO_BRANCH = ('IncludeLaunchDescription', 'TimerEvent')
"""Events whose consequences belong to the branch of the action itself."""


class Watch:
    """Stores the actions that launch visits as a tree of branches.

    :param executed: a function that is called as executed(branch, context) after each action.
    :param instead: functions that replace the execution of an action, by the name of the action's class.
    :param came_back: the numbers of processes that were started again. The plan already contains the actions that follow their
        start and end.
    :ivar phase: the phase of the current action.
    :ivar outline: the root of all branches so far.
    :ivar branch: the branch of the action that launch entered last.
    :ivar timers: the branch of each timer, because launch has one handler for all timers.
    :ivar reactions: how often handlers have returned actions. Above a maximum, their actions are ignored, so that the launch
        ends.
    """

    def __init__(
        self, executed: Executed, instead: dict[str, Callable[[Any, LaunchContext], Any]], came_back: Collection[int]
    ) -> None:
        self._executed = executed
        self._instead = instead
        self._came_back = came_back
        self.phase = 'launch'
        self.outline = Branch('')
        self.branch = self.outline
        self.timers: dict[Any, Branch] = {}
        self.reactions = 0
        self._open: list[Branch] = [self.outline]
        self._parents: dict[int, list[tuple[Any, Branch]]] = {}
        """For each handler, by its `id()`: the handler, and the branch of the action that registered it, once for each
        registration.
        """
        self._failure: Exception | None = None

    @property
    def is_endless(self) -> bool:
        """Whether the number of reactions exceeds the maximum."""
        return self.reactions > MOST_REACTIONS

    def enter(self, entity: Any, context: LaunchContext) -> None:
        """Begin a branch. :class:`launch._observer.Observer` describes this method and all methods below."""
        parent = self._open[-1]
        if isinstance(entity, Action):
            parent = self.branch = self._branch_of(entity, parent)
            if hasattr(entity, 'period'):
                self.timers[entity] = parent
        self._open.append(parent)

    def _branch_of(self, action: Any, parent: Branch) -> Branch:
        condition = None if action.condition is None else action.condition.in_words
        return parent.add(Branch(action, written_origin(action), condition))

    def instead_of(self, action: Any) -> Callable[[Any, Any], Any] | None:
        return self._instead.get(type(action).__name__)

    def executed(self, action: Any, context: LaunchContext) -> None:
        self.branch_now.is_taken = True
        self._executed(self.branch_now, context)

    @property
    def branch_now(self) -> Branch:
        """The branch of the innermost action that launch visits now."""
        return self._open[-1]

    def leads_to(self, entity: Any, entities: Any) -> None:
        pass

    def leave(self, entity: Any, context: LaunchContext, error: Exception | None) -> None:
        branch = self._open.pop()
        # the surrounding actions fail with the same error, so only the first one counts
        if error is not None and error is not self._failure:
            self._failure, branch.condition = error, None

    def event(self, event: Event, context: LaunchContext) -> None:
        pass

    def ignores(self, handler: Any, event: Event) -> bool:
        is_known = isinstance(handler, OnActionEventBase) and getattr(event, 'pid', None) in self._came_back
        return id(handler) in self._parents and (self.is_endless or is_known)

    def answered(self, handler: Any, event: Event, answer: Any) -> None:
        known = self._parents.get(id(handler))
        parent = self.outline if known is None else known[-1][1]
        if known is not None and answer is not None:
            kind = type(event).__name__
            self.phase = _PHASES.get(kind, self.phase)
            is_something = isinstance(answer, LaunchDescriptionEntity) or bool(answer)
            self.reactions += is_something
            parent = self.timers.get(getattr(event, 'timer_action', None), parent)
            if kind not in _NO_BRANCH and is_something:
                parent = self._reaction(handler, event, parent)
        self._open.append(parent)

    def _reaction(self, handler: Any, event: Event, parent: Branch) -> Branch:
        """Return the branch of the handler that runs now."""
        text = _EVENTS.get(type(event).__name__, f'on {event.name}').format(name=getattr(event, 'process_name', ''))
        branch = parent.add(Branch(text))
        branch.is_taken = True
        return branch

    def handled(self, handler: Any, event: Event) -> None:
        self._open.pop()

    def registered(self, handler: Any) -> None:
        self._parents.setdefault(id(handler), []).append((handler, self.branch))

    def unregistered(self, handler: Any) -> None:
        pass


def written_origin(action: Any) -> Origin | None:
    """Return the place at which a launch file creates the action. Return None if launch itself creates it."""
    if action.is_made_by_launch:
        return None
    origin: Origin | None = action.origin
    return None if origin is None or not _is_students(origin.file) else origin
