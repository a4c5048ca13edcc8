"""Functions that record unusual behaviour of a running program as facts, which edulaunch uses for advice.

Examples are waits that can never end, sleeps in callbacks, and requests without a reply. In these cases, ROS 2 hangs or reports
nothing.
Further facts about a node are recorded when it is destroyed, or at the end of a recording.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from edulaunch.engine.graph.parameters import pattern_matches
from edulaunch.engine.interfaces.message import Message, Notices
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.frame_owner import student_line, waiting_line
from edulaunch.engine.sim.task import current_task, running_task
from rclpy.node_parts.core import core_of
from rclpy.process_state import process_state

if TYPE_CHECKING:
    from edulaunch.engine.sim.task import Task
    from rclpy.impl.entity import Entity
    from rclpy.impl.protocols import ContextProtocol, ExecutorProtocol, NodeProtocol
    from rclpy.node_parts.core import NodeCore


def callback_name(entity: Any) -> str | None:
    """Return the name of an entity's callback, or None if it has no callback."""
    callback: Any = getattr(entity, 'callback', None)
    while isinstance(callback, partial):
        callback = callback.func
    name: str | None = getattr(callback, '__name__', None)
    return name


def node_name(entity: Entity) -> str | None:
    """Return the full name of the entity's node if no executor spins the node, and otherwise None."""
    executor = entity.ready_list.executor
    nodes = [] if executor is None else executor.get_nodes()
    return next((core_of(node).full_name for node in nodes if core_of(node).ready_list is entity.ready_list), None)


POLLS = 5
"""The number of checks of a future in one callback, during simulated time, that counts as a wait for the future."""


def note_wait(waiting: str, entity: Any, line: dict[str, Any] | None = None) -> None:
    """Record a callback that waits for `entity`, if the executor cannot serve `entity` before the callback ends.

    :param waiting: the form of the wait: 'call', 'look' (in a loop), 'await', or the name of the function that spins.
    """
    _note('callback waits', entity, {'waiting': waiting, **entity.rcl_awaited()}, line)


def note_rate(entity: Entity) -> None:
    """Record a `rate.sleep()`, if no executor can call the rate's timer."""
    _note('rate in callback', entity, {})


def _note(kind: str, entity: Entity, data: dict[str, Any], line: dict[str, Any] | None = None) -> None:
    data = {'node': node_name(entity), 'callback': callback_name(_running_entity(entity)), **data}
    _keep(kind, {**data, **(student_line() if line is None else line)})


def note_spin(function: str, node: NodeProtocol, executor: ExecutorProtocol) -> None:
    """Record that a callback spins its own node, and whether the executor could call another callback meanwhile."""
    core = core_of(node)
    others = [entity for kind in (core.timers, core.subscriptions, core.services, core.clients, core.guards) for entity in kind]
    in_vain = not any(entity.callback_group.can_execute(entity) for entity in others)
    _note_spin('spin in callback in vain' if in_vain else 'spin in callback', function, node, executor)


def note_lost_node(function: str, node: NodeProtocol, executor: ExecutorProtocol) -> None:
    """Record that a callback passed its node to another executor, so that the current executor no longer spins the node."""
    _note_spin('node taken away', function, node, executor)


def _note_spin(kind: str, function: str, node: NodeProtocol, executor: ExecutorProtocol) -> None:
    data = {'node': core_of(node).full_name, 'callback': callback_name(executor.rcl_running_entity()), 'spins': function}
    _keep(kind, {**data, **student_line()})


def note_foreign_future(node: NodeProtocol, entity: Any) -> None:
    """Record a wait for the client of another node, if no executor spins that node."""
    data = {'node': core_of(node).full_name, 'other': entity.rcl_node_name(), **entity.rcl_awaited()}
    _keep('other node spun', {**data, **student_line()})


def note_no_result(callback: Callable[..., Any]) -> None:
    """Record that a callback for changed parameters did not return a SetParametersResult."""
    code = getattr(callback, '__code__', None)
    place = {} if code is None else {'file': code.co_filename, 'line': code.co_firstlineno}
    _keep('no parameter result', {'callback': getattr(callback, '__name__', 'it'), **place})


def note_no_goal_response(node: NodeProtocol, callback: Callable[..., Any], returned: Any) -> None:
    """Record that a callback for new goals did not return a GoalResponse."""
    code = getattr(callback, '__code__', None)
    place = {} if code is None else {'file': code.co_filename, 'line': code.co_firstlineno}
    name = getattr(callback, '__name__', 'it')
    _keep('no goal response', {'node': core_of(node).full_name, 'callback': name, 'returned': repr(returned)[:40], **place})


def note_ignored_argument(message_class: type[Message], name: str, near: str | None) -> None:
    """Record an unknown keyword argument of a message. As in Jazzy, the message ignores the argument."""
    data = {
        'type': message_class.__name__,
        'field': name,
        'near': near,
        'fields': list(message_class.get_fields_and_field_types()),
    }
    _keep('argument ignored', {**data, **student_line()})


Notices.ignored = note_ignored_argument


def _keep(kind: str, data: dict[str, Any]) -> None:
    current_process().fact(kind, (data.get('file'), data.get('line')), data)


def _running_entity(entity: Entity) -> Any:
    executor = entity.ready_list.executor
    busy = entity.callback_group.busy_with
    return busy if busy is not None or executor is None else executor.rcl_running_entity()


SHORT_S = 0.01
"""The longest sleep that has no noticeable effect, in seconds."""


def note_sleep(seconds: float) -> None:
    """Record a `time.sleep` in a callback, that is, in a task that spins. Each `time.sleep` calls this function."""
    if not isinstance(seconds, (int, float)) or seconds < SHORT_S:
        return
    task, state = current_task(), process_state()
    for executor in (executor for context in state.contexts for executor in context.executors):
        if executor.spinner is task and (entity := executor.rcl_running_entity()) is not None:
            data = {'callback': callback_name(entity), 'node': node_name(entity), 'seconds': seconds}
            line = student_line()
            state.process.fact('sleep in callback', (line.get('file'), line.get('line')), {**data, **line})
            return


LONG_NS = 1_000_000_000
"""How long a client must wait for a server before the wait is recorded as a fact."""


def note_lost_request(endpoint: Any, name: str, kind: str) -> None:
    """Record a request to a service or action that has no server.

    :param endpoint: the client in the graph, or the endpoint of an action client that sends goals.
    :param kind: 'service' or 'action'.
    """
    _note_endpoint('request lost', endpoint, name, kind)


def note_long_wait(endpoint: Any, name: str, kind: str) -> None:
    """Record that a client has waited for a long time."""
    _note_endpoint('server awaited', endpoint, name, kind)


def note_server_came(endpoint: Any, name: str) -> None:
    """Record that the server for which a client waited has appeared."""
    current_process().fact_over('server awaited', (endpoint.node.index, name))


def _note_endpoint(what: str, endpoint: Any, name: str, kind: str) -> None:
    data = {'node': endpoint.node.fully_qualified_name, 'name': name, 'kind': kind, **student_line()}
    current_process().fact(what, (endpoint.node.index, name), data)


Facts = Iterator[tuple[str, dict[str, Any]]]
WAITING_NS = 500_000_000
"""How long a message or request must wait for a callback before the wait counts as unusual."""
VERY_LONG_NS = 3_000_000_000
"""A callback that delays a timer for this time is assumed not to end."""
ENDLESS_NS = 7_000_000_000
"""How much longer a timer's own callback must run until it is assumed not to end."""
DEEP = 5
"""The smallest depth at which a full queue is unusual, because it drops messages. Smaller queues are often full briefly."""
GIVEN_BY_ROS = ('use_sim_time', 'start_type_description_service', 'qos_overrides.')


def odd_facts(core: NodeCore) -> Facts:
    """Yield facts about a node: unused parameter values, waiting messages and replies, a callback that does not end, and a
    node that no executor spins.
    """
    yield from _undeclared(core)
    yield from _passed_over(core)
    waiting = [*_waiting(core)]
    yield from waiting
    executor = core.ready_list.executor
    task = None if executor is None else executor.spinner
    if executor is not None and task is not None and task is not running_task():
        yield from _going_on(core, executor, task, waiting_line(task), bool(waiting))
    if not core.was_spun:
        yield from _never_spun(core)


def _undeclared(core: NodeCore) -> Facts:
    store = getattr(core, 'parameters', None)
    if store is None:  # the constructor failed before this point
        return
    for name, override in core.overrides.items():
        if name not in core.declared and not name.startswith(GIVEN_BY_ROS):
            data = {'node': core.full_name, 'parameter': name, 'value': repr(override.value), 'origin': override.origin}
            yield 'parameter not declared', {**data, 'declared': sorted(set(store.values))}


def _passed_over(core: NodeCore) -> Facts:
    """Yield a fact for each parameter file whose keys all name other nodes."""
    keys: dict[str, dict[str, str]] = {}
    for parsed in core.arguments:
        for pattern, overrides in parsed.parameters.items():
            for override in overrides.values():
                file, separator, line = override.origin.rpartition(' line ')
                if separator:
                    keys.setdefault(file, {}).setdefault(pattern, line)
    for file, lines in keys.items():
        if not any(pattern_matches(pattern, core.full_name) for pattern in lines):
            yield (
                'keys for no node',
                {'node': core.full_name, 'file': file, 'keys': [*lines], 'line': int(min(lines.values(), key=int))},
            )


def _waiting(core: NodeCore) -> Facts:
    now_ns = core.graph.sim.now_ns
    for subscription in core.subscriptions:
        queue = subscription.endpoint.queue
        if queue and (now_ns - queue[0][1] >= WAITING_NS or DEEP <= len(queue) == queue.maxlen):
            data = {'node': core.full_name, 'topic': subscription.endpoint.topic_name, 'messages': len(queue)}
            yield 'messages wait', {**data, 'depth': queue.maxlen, 'since_s': _elapsed_s(core, queue[0][1])}
    for client in core.clients:
        if client.endpoint.queue:
            yield 'reply waits', {'node': core.full_name, 'service': client.endpoint.service_name}


def note_interruption(context: ContextProtocol) -> None:
    """Record which callbacks do not end, and where the main thread waits, when a signal is about to end the program."""
    state = process_state()
    state.interrupted_at = student_line()
    for executor in context.executors:
        for core in map(core_of, executor.get_nodes() if executor.spinner is current_task() else ()):
            for kind, data in _going_on(core, executor, current_task(), state.interrupted_at, any(_waiting(core))):
                _keep(kind, data)


def _going_on(core: NodeCore, executor: ExecutorProtocol, task: Task, line: dict[str, Any], something_waits: bool) -> Facts:
    """Yield a fact about a callback that does not end, if timers of the node are long overdue because of it.

    The callback also counts if it waits without a timeout while messages or replies wait. `line` is the line at which it waits.
    """
    entity, late_ns = executor.rcl_running_entity(), core.graph.sim.now_ns - VERY_LONG_NS
    late = [timer for timer in core.timers if timer.rcl_due_ns <= late_ns]
    due = [timer for timer in late if timer is not entity]
    is_endless = task.waits_for_ever() or (entity in late and entity.rcl_due_ns <= late_ns - ENDLESS_NS)
    if entity is not None and entity.ready_list is core.ready_list and (due or (something_waits and is_endless)):
        timers = [callback_name(timer) or 'timer' for timer in due]
        yield 'callback goes on', {'node': core.full_name, 'callback': callback_name(entity), 'timers': timers, **line}


def _never_spun(core: NodeCore) -> Facts:
    topics = [subscription.endpoint.topic_name for subscription in core.subscriptions]
    services = [service.endpoint.service_name for service in core.services]
    own = [name for name in services if not name.startswith(f'{core.full_name}/')]
    if core.timers or topics or own:
        task = core.process.lifecycle.task
        is_over = task is running_task() or task.finished
        line = process_state().interrupted_at if is_over else waiting_line(task)
        data = {'node': core.full_name, 'timers': len(core.timers), 'topics': topics, 'services': own}
        yield 'node not spun', {**data, **line}


def _elapsed_s(core: NodeCore, at_ns: int) -> float:
    return (at_ns - core.graph.sim.start_ns) / 1e9
