"""The steps of a launch, which are its actions and events, and their rows of plain data."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from launch.action import Action
from launch.actions.execute_local import ExecuteLocal
from launch.substitution import Substitution
from launch.substitutions.launch_configuration import LaunchConfiguration

from edulaunch.advice.plan.explanation import add_facts, entry, is_declaration, kind_and_text
from edulaunch.advice.plan.titles import Branch
from edulaunch.advice.plan.why import declared_steps, parameter_chain, setter_steps

Row = dict[str, Any]
LAUNCH_OWN = frozenset(('timer', 'emit_event'))
"""Events with which launch itself ends a process. They belong to the user only if a launch file created them."""
SHOWN_EVENTS = frozenset(('ProcessStarted', 'ProcessExited', 'TimerEvent', 'Shutdown'))
"""Events of launch that are steps even if no handler of a launch file waits for them."""
LONGEST_VALUE = 2000
"""The maximum number of characters of a value in a row. A robot description is longer."""


class Step(Branch):
    """An action or event of a launch, with the data that are known while the launch runs.

    :ivar number: the index of the step in the trace.
    :ivar parent: the index of the enclosing step, or -1.
    :ivar depth: the number of enclosing steps.
    :ivar state: 'waiting', 'visiting', 'taken', 'left out' or 'failed'.
    :ivar order: the position among all visits and events of the launch, from 1. While the step waits, it is 0.
    :ivar at_ns: the time at which the visit began, or None while the step waits.
    :ivar changes: the launch configurations and environment variables that have changed since the previous step in this order.
    :ivar values: the launch configurations at an action that was left out.
    :ivar runs: [pid, start, end, exit code] of each run of the step's process.
    :ivar fired_ns: the times at which a handler handled an event, or a timer fired.
    :ivar fired: the numbers of the steps whose handlers handled this event.
    :ivar handlers: the event handlers of a launch file that this action registered.
    :ivar due_ns: the time at which a timer will fire.
    :ivar about: the step of the process or timer to which an event belongs.
    :ivar make_item: a function that creates the item on first use.
    :ivar waiting: the steps of nested actions that have not been visited yet, by `id()` of the action.
    """

    number = parent = -1
    depth = order = 0
    state = 'waiting'
    at_ns: int | None = None
    due_ns: int | None = None
    error: str | None = None
    about: Step | None = None
    changes: Mapping[str, dict[str, Any]] = {}
    values: Mapping[str, Any] = {}
    runs: Sequence[list[Any]] = ()
    fired_ns: Sequence[int] = ()
    fired: Sequence[int] = ()
    handlers: Sequence[Any] = ()
    waiting: dict[int, Step] | None = None
    make_item: Callable[[], Any] | None = None
    _item: Any = None

    @property
    def item(self) -> Any:
        """The item of the plan, as in :class:`Branch`. It is created on first use."""
        if self._item is None and self.make_item is not None:
            make, self.make_item = self.make_item, None
            try:
                self._item = make()
            except Exception as error:  # the file has changed since then; the launch itself succeeded
                self._item = {'kind': 'action', 'name': f'{type(self.action).__name__} ({error})'}
        return self._item

    @item.setter
    def item(self, item: Any) -> None:
        self._item = item

    @property
    def process_name(self) -> str:
        """The unique name of the process that the action starts, or an empty string for other actions."""
        return name_of_process(self.action)

    @property
    def is_event(self) -> bool:
        """Whether the step is an event. Otherwise, it is an action."""
        return not isinstance(self.action, Action)

    @property
    def is_running(self) -> bool:
        """Whether the process of the step is running."""
        return bool(self.runs) and self.runs[-1][2] is None


def name_of_process(action: Any) -> str:
    """Return the unique name of the process that an action starts.

    Return an empty string before the start and for other actions.
    """
    return (isinstance(action, ExecuteLocal) and action.process_description.final_name) or ''


def row_of(step: Step) -> Row:
    """Return the row of a step as plain data, with times in nanoseconds since the start."""
    row = _event_row(step) if step.is_event else _action_row(step)
    row |= {'number': step.number, 'parent': step.parent, 'state': step.state, 'time': step.at_ns, 'order': step.order}
    if step.changes:
        row['changes'] = {
            kind: {name: _plain(value) for name, value in changed.items()} for kind, changed in step.changes.items()
        }
    optional = {
        'error': step.error,
        'condition': step.condition,
        'runs': [list(run) for run in step.runs],
        'fired': list(step.fired),
        'fired_at': list(step.fired_ns),
        'due': step.due_ns,
        'process': step.process_name,
        'handlers': [waits_for(handler) for handler in step.handlers],
    }
    return row | {name: value for name, value in optional.items() if value not in (None, '', [])}


def _event_row(step: Step) -> Row:
    event, about = step.action, step.about
    name = type(event).__name__
    row: Row = {'kind': 'event', 'text': _event_text(event, about), 'event': name, 'details': []}
    if about is not None:
        row['about'] = about.number
    return row


def _event_text(event: Any, about: Step | None) -> str:
    process = getattr(event, 'process_name', '')
    name = type(event).__name__
    if name == 'ProcessExited':
        return f'{process} ended with exit code {event.returncode}'
    if name == 'TimerEvent':
        place = '' if about is None or about.place is None else f' of line {about.place.line}'
        return f'the timer{place} ran out'
    texts = {'ProcessStarted': f'{process} started', 'Shutdown': f'shutdown: {getattr(event, "reason", "")}'}
    return texts.get(name, f'{name}{f" of {process}" if process else ""}')


def _action_row(step: Step) -> Row:
    kind, text = kind_and_text(step)
    file, line = step.place or (None, None)
    shown = entry(kind, text, file, line)
    if step.item is not None and step.is_taken:
        add_facts(shown, step)
    row: Row = {'kind': kind, 'text': shown['text'], 'file': file, 'line': line}
    row['details'] = [
        [one['kind'], one['text'], one['file'], one['line']]
        for one in shown['children']
        if one['kind'] not in ('never', 'parameter')
    ]
    if step.origin is not None and step.origin != step.place:
        row['details'].append(['created', 'created at', *step.origin])
    values = [*_chains(step, shown), *_reasons(step)]
    if values:
        row['values'] = values
    return row


def _chains(step: Step, shown: Row) -> Iterator[Row]:
    """Yield the arguments and parameters of a step. Each one contains the chain of values that led to its value."""
    if is_declaration(step):
        yield {
            'kind': 'argument',
            'name': step.item['name'],
            'value': _plain(step.item['value']),
            'chain': _steps(declared_steps(step)),
        }
    for one in shown['children']:
        if one['kind'] == 'parameter':
            chain = _steps(parameter_chain(step, one['name'])) if 'name' in one else []
            yield {'kind': 'parameter', 'name': one.get('name', ''), 'value': _plain(one.get('value')), 'chain': chain}


def _reasons(step: Step) -> Iterator[Row]:
    """Yield the launch configurations that the condition of a skipped action reads."""
    if step.state != 'left out':
        return
    for name in dict.fromkeys(configurations_in(step.action.condition)):
        setter = step.setters.get(name)
        chain = [] if setter is None else _steps(setter_steps(setter))
        yield {'kind': 'reason', 'name': name, 'value': _plain(step.values.get(name)), 'chain': chain}


def _steps(chain: list[Row]) -> list[Row]:
    return [{**step, 'value': _plain(step['value']), 'argument': _steps(step['argument'])} for step in chain]


def configurations_in(value: Any, depth: int = 0) -> Iterator[str]:
    """Yield the names of the launch configurations that a condition or substitution reads, if the names are literal."""
    if isinstance(value, LaunchConfiguration):
        yield ''.join(getattr(part, 'text', '') for part in value.variable_name)
    elif isinstance(value, (list, tuple)):
        for part in value:
            yield from configurations_in(part, depth)
    elif depth < 8 and (isinstance(value, Substitution) or hasattr(value, 'evaluate')):
        for part in vars(value).values():
            yield from configurations_in(part, depth + 1)


_ONCE = ('Command', 'PythonExpression')
"""Substitutions that run a program or code of the student."""


def is_repeatable(value: Any, depth: int = 0) -> bool:
    """Return whether substitutions can be evaluated a second time without any effect."""
    if isinstance(value, (list, tuple, set)):
        return all(is_repeatable(part, depth) for part in value)
    if isinstance(value, dict):
        return all(is_repeatable(part, depth) for pair in value.items() for part in pair)
    module = type(value).__module__
    if isinstance(value, Substitution) and (type(value).__name__ in _ONCE or not module.startswith(('launch.', 'launch_ros.'))):
        return False
    is_ours = module.startswith(('launch.', 'launch_ros.')) and hasattr(value, '__dict__') and not isinstance(value, Action)
    return not is_ours or (depth < 12 and all(is_repeatable(part, depth + 1) for part in vars(value).values()))


_WAITS = {
    'OnProcessStart': 'the start of {}',
    'OnProcessExit': 'the end of {}',
    'OnActionEventBase': 'the end of {}',
    'OnProcessIO': 'output of {}',
    'OnExecutionComplete': 'the execution of {}',
    'OnShutdown': 'the shutdown of the launch',
    'OnIncludeLaunchDescription': 'a launch description that is included',
}


def waits_for(handler: Any) -> str:
    """Return a description of what an event handler waits for."""
    words = _WAITS.get(type(handler).__name__)
    if words is None:
        return f'{type(handler).__name__}: {handler.matcher_description}'.partition(' at 0x')[0]
    only = handler.only_action
    if only is None:
        return words.format('any process' if 'process' in type(handler).__name__.lower() else 'any action')
    return words.format(name_of_process(only) or kind_and_text(Branch(only))[1])


def _plain(value: Any) -> Any:
    """Return a value as plain data. Long strings are shortened."""
    if value is None or isinstance(value, (bool, int)):
        return value
    if isinstance(value, float):
        return value if value - value == 0 else str(value)
    if isinstance(value, (list, tuple)):
        return [_plain(one) for one in value[:200]]
    text = str(value)
    return text if len(text) <= LONGEST_VALUE else f'{text[:LONGEST_VALUE]}…'
