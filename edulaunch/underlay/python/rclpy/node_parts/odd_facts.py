"""What is odd about a node when it leaves, or at the end of a record: facts in plain data, of which advice is made."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.processes.student_line import waiting_line
from edulaunch.sim.task import running_task
from rclpy.execution.names import callback_name

if TYPE_CHECKING:
    from rclpy.node_parts.core import NodeCore

Facts = Iterator[tuple[str, dict[str, Any]]]
LONG_NS = 500_000_000
"""How long something waits for a callback until that is odd."""
VERY_LONG_NS = 3_000_000_000
"""A callback that holds up a timer for so long does not end."""
DEEP = 5
"""A queue of so many messages that is full: the next one throws one away. Smaller ones are often full for a moment."""
GIVEN_BY_ROS = ('use_sim_time', 'start_type_description_service', 'qos_overrides.')


def odd_facts(core: NodeCore) -> Facts:
    """Values for parameters that were never declared; messages and replies that nobody takes; a node that nobody spins."""
    yield from _undeclared(core)
    waiting = [*_waiting(core)]
    yield from waiting
    yield from _going_on(core, bool(waiting))
    if not core.was_spun:
        yield from _never_spun(core)


def _undeclared(core: NodeCore) -> Facts:
    store = getattr(core, 'parameters', None)
    if store is None:  # the constructor did not come so far
        return
    for name, override in core.overrides.items():
        if name not in core.declared and not name.startswith(GIVEN_BY_ROS):
            data = {'node': core.full_name, 'parameter': name, 'value': repr(override.value), 'origin': override.origin}
            yield 'parameter not declared', {**data, 'declared': sorted(set(store.values))}


def _waiting(core: NodeCore) -> Facts:
    now_ns = core.graph.sim.now_ns
    for subscription in core.subscriptions:
        queue = subscription._impl.queue
        if queue and (now_ns - queue[0][1] >= LONG_NS or DEEP <= len(queue) == queue.maxlen):
            data = {'node': core.full_name, 'topic': subscription._impl.topic_name, 'messages': len(queue)}
            yield 'messages wait', {**data, 'depth': queue.maxlen, 'since_s': _elapsed_s(core, queue[0][1])}
    for client in core.clients:
        if client._impl.queue:
            yield 'reply waits', {'node': core.full_name, 'service': client._impl.service_name}


def _going_on(core: NodeCore, something_waits: bool) -> Facts:
    """A callback that does not end: it waits without a time limit while something else waits, or timers are due since long."""
    executor = core.ready_list.executor
    task = None if executor is None else executor.spinner
    if executor is None or task is None or task is running_task():
        return
    entity, late_ns = executor.running_entity(), core.graph.sim.now_ns - VERY_LONG_NS
    due = [timer for timer in core.timers if timer.due_ns <= late_ns and timer is not entity]
    if entity is not None and entity.ready_list is core.ready_list and (due or (something_waits and task.waits_for_ever())):
        timers = [callback_name(timer) or 'timer' for timer in due]
        data = {'node': core.full_name, 'callback': callback_name(entity), 'timers': timers}
        yield 'callback goes on', {**data, **waiting_line(task)}


def _never_spun(core: NodeCore) -> Facts:
    topics = [subscription._impl.topic_name for subscription in core.subscriptions]
    services = [service._impl.service_name for service in core.services]
    own = [name for name in services if not name.startswith(f'{core.full_name}/')]
    if core.timers or topics or own:
        task = core.process.task
        line = {} if task is running_task() or task.finished else waiting_line(task)
        data = {'node': core.full_name, 'timers': len(core.timers), 'topics': topics, 'services': own}
        yield 'node not spun', {**data, **line}


def _elapsed_s(core: NodeCore, at_ns: int) -> float:
    return (at_ns - core.graph.sim.start_ns) / 1e9
