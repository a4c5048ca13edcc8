"""Record what a launch does while it runs, for the live view, for replays and for `edulaunch launch --step`.

A trace is an observer of one launch service. It stores a step for each action and each event. A step contains the changes of
launch configurations and environment. :meth:`LaunchTrace.as_data` returns the steps as plain data.
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.actions.execute_local import ExecuteLocal

from edulaunch.advice.plan.explanation import HIDDEN
from edulaunch.advice.plan.items import item_of
from edulaunch.advice.plan.process_items import add_names_and_parameters
from edulaunch.advice.plan.stepping import Stepper
from edulaunch.advice.plan.steps import LAUNCH_OWN, SHOWN_EVENTS, Step, is_repeatable, row_of
from edulaunch.advice.plan.titles import Branch, Setters
from edulaunch.advice.plan.watching import Watch, written_origin
from edulaunch.engine.recording import views

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

    from edulaunch.engine.processes.process import Process

_EVALUATED_AGAIN = ('msg', 'name', 'period', 'sigterm_timeout', 'sigkill_timeout', 'descriptions_to_load')
"""Attributes that the items of some actions evaluate a second time."""
MOST_STEPS = 20_000
MOST_TIMES = 500
"""Limits for a launch whose handlers fire forever: the number of steps in the trace, and of the events or runs of one step."""


class LaunchTrace(Watch):
    """Observes the launch service of a process.

    :ivar steps: all steps. The index of a step in the list is its number.
    :ivar touched: the numbers of steps in the order in which they were created or changed. A number may occur several times.
    :ivar stepper: determines where the launch stops (see :class:`Stepper`).
    :ivar on_stop: a function that is called with the step before which launch stops. The default stops the whole simulation.
    """

    def __init__(self, process: Process) -> None:
        super().__init__(lambda branch, context: None, {}, ())
        self._process = process
        self._sim = process.sim
        self._context: LaunchContext | None = None
        self._setters = Setters()
        self._configurations: dict[str, Any] = {}
        self._environment: dict[str, str] = {}
        self._environment_at_start: dict[str, str] | None = None
        self._step_of: dict[int, Step] = {}
        self._event: Step | None = None
        self._order = 0
        self.steps: list[Step] = []
        self.touched: list[int] = []
        self.stepper = Stepper()
        self.on_stop: Callable[[Step], object] = lambda step: self._process.lifecycle.task.suspend()

    # -- events of launch

    def enter(self, entity: Any, context: LaunchContext) -> None:
        self._context = context
        if _says_nothing(entity):
            self._open.append(self.branch_now)
            return
        super().enter(entity, context)
        if isinstance(entity, Action):
            step = self.branch
            assert isinstance(step, Step)
            self._begin(step, context)
            if self.stepper.stops_before(step):
                self._stop(step)

    def _branch_of(self, action: Any, parent: Branch) -> Branch:
        waiting = parent.waiting.pop(id(action), None) if isinstance(parent, Step) and parent.waiting else None
        if waiting is not None:
            return waiting
        return self._add(_step_of(action), parent)

    def _add(self, step: Step, parent: Branch) -> Step:
        step.parent_origin = parent.place
        step.parent = parent.number if isinstance(parent, Step) else -1
        step.depth = parent.depth + 1 if isinstance(parent, Step) else 0
        step.number = len(self.steps)
        if step.number < MOST_STEPS:
            parent.add(step)
            self.steps.append(step)
            self.touched.append(step.number)
            if isinstance(step.action, Action):
                self._step_of[id(step.action)] = step
        return step

    def _begin(self, step: Step, context: LaunchContext) -> None:
        """Store the time at which launch begins to visit a step, and the changes since the previous step."""
        self._order += 1
        step.order, step.at_ns, step.state = self._order, self._now(), 'visiting'
        configurations = {name: _copied(value) for name, value in context.launch_configurations.items()}
        if self._environment_at_start is None:
            self._environment_at_start = self._environment = dict(context.environment)
        if configurations != self._configurations:
            step.changes = {'configurations': _differences(self._configurations, configurations)}
            self._configurations = configurations
        if context.environment != self._environment:
            environment = dict(context.environment)
            step.changes = {**step.changes, 'environment': _differences(self._environment, environment)}
            self._environment = environment
        self._touch(step)

    def _now(self) -> int:
        return self._sim.now_ns - self._sim.start_ns

    def _touch(self, step: Step) -> None:
        # record the step even if it was also the last one to change, because that change may already have been returned
        if step.number < MOST_STEPS:
            self.touched.append(step.number)

    def executed(self, action: Any, context: LaunchContext) -> None:
        step = self.branch_now
        if step.action is not action:
            self._setters.executed(self._silent(action, context))
            return
        assert isinstance(step, Step)
        step.is_taken = True
        if hasattr(action, 'period') and isinstance(action.actions, (list, tuple)):
            self._expect(action.actions)
        if isinstance(action, ExecuteLocal):
            step.make_item = lambda: self._process_item(action, context)
            step.setters = self._setters.now
            return
        item = self._item(action, context)
        if step.origin is not None or item is None or item['kind'] not in LAUNCH_OWN:
            step.item = item
        self._setters.executed(step)

    def _silent(self, action: Any, context: LaunchContext) -> Branch:
        branch = Branch(action)
        branch.item = self._item(action, context)
        return branch

    def _item(self, action: Any, context: LaunchContext) -> dict[str, Any] | None:
        if not is_repeatable([getattr(action, name, None) for name in _EVALUATED_AGAIN]):
            return None
        try:
            return item_of(action, context, self._environment_at_start or {}, 0)
        except Exception:  # an item without a valid description must not end a running launch
            return {'kind': 'action', 'name': type(action).__name__}

    def _process_item(self, action: Any, context: LaunchContext) -> dict[str, Any]:
        """Return the plan item of a process. It is created on first use, because that takes longer than starting the process."""
        item = self._item(action, context) or {'kind': 'action', 'name': type(action).__name__}
        if item['kind'] == 'node':
            add_names_and_parameters(item, self._process.host.parameter_entries)
        return item

    def leads_to(self, entity: Any, entities: Any) -> None:
        if isinstance(entities, (list, tuple)):
            self._expect(entities)

    def _expect(self, entities: Iterable[Any]) -> None:
        """Create the steps of the actions that launch is going to visit."""
        parent = self.branch_now
        if not isinstance(parent, Step):
            return
        for entity in entities:
            if parent.waiting is None:
                parent.waiting = {}
            if isinstance(entity, Action) and id(entity) not in parent.waiting:
                parent.waiting[id(entity)] = self._add(_step_of(entity), parent)

    def leave(self, entity: Any, context: LaunchContext, error: Exception | None) -> None:
        step = self.branch_now
        is_first = error is not None and error is not self._failure
        super().leave(entity, context, error)
        if isinstance(step, Step) and step.action is entity:
            if is_first:
                step.state, step.error = 'failed', f'{type(error).__name__}: {error}'
            elif step.is_taken:
                step.state = 'taken'
                if hasattr(entity, 'period') and step.item is not None and step.at_ns is not None:
                    step.due_ns = step.at_ns + round(step.item.get('period', 0.0) * 1e9)
            else:
                step.state, step.setters = 'left out', self._setters.now
                step.values = dict(self._configurations)
            self._touch(step)

    def event(self, event: Any, context: LaunchContext) -> None:
        self._context, self._event = context, None
        name, action = type(event).__name__, getattr(event, 'action', None)
        step = self._step_of.get(id(action))
        if step is not None and name == 'ProcessStarted':
            step.runs = [*step.runs[-MOST_TIMES:], [event.pid, self._now(), None, None]]
            self._touch(step)
        elif step is not None and name == 'ProcessExited' and step.runs:
            step.runs[-1][2:] = [self._now(), event.returncode]
            self._touch(step)
        timer = self._step_of.get(id(getattr(event, 'timer_action', None)))
        if timer is not None:
            timer.fired_ns = [*timer.fired_ns, self._now()]
            self._touch(timer)
        is_shown = name in SHOWN_EVENTS or not type(event).__module__.startswith('launch.')
        if is_shown and (timer is None or timer.origin is not None):
            shown = self._event_step(event, step or timer)
            if self.stepper.stops_at(shown):
                self._stop(shown)

    def _event_step(self, event: Any, about: Step | None) -> Step:
        """Return the step of the event that launch processes now. Create the step if it does not exist."""
        if self._event is None:
            self._event = self._add(Step(event), self.outline)
            self._order += 1
            self._event.order, self._event.at_ns, self._event.state = self._order, self._now(), 'taken'
            self._event.about = about
            self._touch(self._event)
        return self._event

    def _reaction(self, handler: Any, event: Any, parent: Branch) -> Branch:
        """Return the parent step. A handler has no step of its own, because the step of the event lists the handlers."""
        return parent

    def registered(self, handler: Any) -> None:
        super().registered(handler)
        step = self.branch_now
        if isinstance(step, Step) and _is_from_a_file(handler, step):
            step.handlers = [*step.handlers, handler]
            with suppress(Exception):  # a handler of the student may describe itself in any way
                self._expect(handler.describe()[1])

    def answered(self, handler: Any, event: Any, answer: Any) -> None:
        known = self._parents.get(id(handler))
        step = known[-1][1] if known is not None else None
        if isinstance(step, Step) and _is_from_a_file(handler, step) and len(step.fired_ns) < MOST_TIMES:
            fired = self._event_step(event, self._step_of.get(id(getattr(event, 'action', None))))
            fired.fired = [*fired.fired, step.number]
            step.fired_ns = [*step.fired_ns, self._now()]
            self._touch(step)
            self._touch(fired)
        super().answered(handler, event, answer)
        if isinstance(answer, (list, tuple)) and not isinstance(self.branch_now.action, str):
            self._expect(answer)

    def ignores(self, handler: Any, event: Any) -> bool:
        return False

    # -- breakpoints

    def _stop(self, step: Step) -> None:
        self.stepper.at = step
        self.on_stop(step)
        self.stepper.at = None

    @property
    def pid(self) -> int:
        """The process id of `ros2 launch`."""
        return self._process.pid

    @property
    def is_over(self) -> bool:
        """Whether the launch has ended."""
        return self._process.returncode is not None

    def as_data(self, since: int = 0) -> dict[str, Any]:
        """Return the trace as plain data: the process id of `ros2 launch`, the step before which the launch waits, and the rows
        of steps.

        :param since: the `count` of an earlier result. Only steps that have changed since then are included.
        """
        numbers = dict.fromkeys(self.touched[since:])
        rows = [row_of(self.steps[number]) for number in numbers]
        at = self.stepper.at
        return {'pid': self.pid, 'at': None if at is None else at.number, 'count': len(self.touched), 'rows': rows}

    def context_before(self, step: Step) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the launch configurations before a step, and the environment variables that have changed (None if removed)."""
        found: dict[str, dict[str, Any]] = {'configurations': {}, 'environment': {}}
        for one in sorted(self.steps, key=lambda one: one.order):
            if one.order <= step.order:
                for kind, changes in one.changes.items():
                    found[kind].update(changes)
        configurations = {name: value for name, value in found['configurations'].items() if value is not None}
        return configurations, found['environment']

    # -- queries

    def signal(self, number: int, signum: signal.Signals) -> str:
        """Make launch send a signal to the process of a step. Return a message for the student."""
        from launch.events.matchers import matches_action
        from launch.events.process import SignalProcess

        step = self._process_step(number)
        if self.is_over or not step.is_running:
            return f'{step.process_name} does not run'
        event = SignalProcess(signal_number=signum, process_matcher=matches_action(step.action))
        self._on_loop(lambda context: context.emit_event_sync(event))
        return f'launch sends {signum.name} to {step.process_name}'

    def restart(self, number: int) -> str:
        """Make launch restart the program of a step. Return a message for the student."""
        step = self._process_step(number)
        if self.is_over or self._context is None or self._context.is_shutdown:
            return 'the launch has ended: launch it again'
        self._on_loop(step.action.start_again)
        return f'launch starts {step.process_name} again'

    def _process_step(self, number: int) -> Step:
        """Return the step with this number.

        :raises ValueError: when the step does not start a process.
        """
        step = self.steps[number] if 0 <= number < len(self.steps) else None
        if step is None or not step.process_name:
            raise ValueError(f'step {number} starts no process')
        return step

    def _on_loop(self, action: Callable[[Any], object]) -> None:
        context = self._context
        assert context is not None
        if context.asyncio_loop is not None:
            context.asyncio_loop.call_soon_threadsafe(action, context)


def _step_of(action: Any) -> Step:
    """Return a new step for an action."""
    condition = action.condition
    words = None if condition is None else getattr(condition, 'in_words', f'if {type(condition).__name__} says so')
    return Step(action, written_origin(action), words)


def _says_nothing(entity: Any) -> bool:
    """Return whether an action shows nothing to a user: it only opens or closes a scope, or calls a function of launch itself."""
    kind = type(entity).__name__
    return kind in HIDDEN or (kind == 'OpaqueFunction' and entity.is_made_by_launch)


def _is_from_a_file(handler: Any, step: Step) -> bool:
    """Return whether a launch file created the handler. Launch itself registers other handlers for each process and timer."""
    if hasattr(step.action, 'event_handler'):
        return step.action.event_handler is handler and step.origin is not None
    return type(handler).__name__ == 'OnActionEventBase'  # the handler for a process's on_exit=


def _copied(value: Any) -> Any:
    """Return a copy of the value of a launch configuration, because `SetRemap` and `SetParameter` append to a list."""
    return tuple(value) if isinstance(value, list) else value


def _differences(before: Mapping[str, Any], after: Mapping[str, Any]) -> dict[str, Any]:
    """Return the entries with a new value. A removed entry has the value None."""
    changed = {name: value for name, value in after.items() if name not in before or before[name] != value}
    return changed | {name: None for name in before if name not in after}


views.register(launch_trace=LaunchTrace, row_of_step=row_of)
