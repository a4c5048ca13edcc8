"""Rules about messages and replies that arrived, but that no callback processed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import name_of_call, script_of, walked
from edulaunch.advice.runs import asking_place, end_place, fact_place, is_ros_own, names_of, own_nodes, programs, speaker
from edulaunch.engine.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LESSON = '09_broadcaster_and_listener'
SECOND = 1.0


@rule(
    'programs.never-spun',
    what=(
        '{node} never spins because its program waits in {calls}(), so none of its callbacks runs',
        '{node} never spins, so none of its callbacks runs',
    ),
    why='a node handles messages, timers and services only while it spins',
    do=(
        'replace the loop in {looping}() with self.create_timer(0.1, self.step), and call rclpy.spin(node) in main()',
        'add the node to the executor before it spins: executor.add_node({added})',
        'call rclpy.spin(node) after you create the node, and do not wait for its callbacks before that',
    ),
    lesson=LESSON,
    level='error',
    hides=('messages.reply-not-taken', 'messages.not-taken', 'tf.empty-buffer', 'tf.unknown-frame', 'turtlesim.slow-commands'),
)
def never_spun(recording: Recording) -> Iterator[Finding]:
    """Report a node that existed for a second and was never in an executor, if it has timers, subscriptions or services."""
    started = {node.name: node.started_s for node in recording.nodes}
    asking = _programs_that_ask(recording)
    for fact in recording.facts:
        if fact.kind == 'node not spun' and fact.time_s - started.get(fact.data['node'], fact.time_s) >= SECOND:
            if _waits_for_somebody(fact.data) or fact.process in asking:
                continue
            topic = next((name for name in fact.data['topics'] if not is_ros_own(name)), '')
            has_line = 'file' in fact.data or not topic
            place = fact_place(recording, fact) if has_line else end_place(recording, 'subscription', topic, fact.data['node'])
            stands_at = str(fact.data.get('calls', '')).partition('.')[2]
            calls = None if stands_at.startswith('spin') else stands_at or None
            if any(not is_ros_own(topic) for topic in fact.data['topics']) or fact.data['timers'] or fact.data['services']:
                facts = {
                    'calls': calls,
                    'looping': fact.data.get('function') if calls in ('sleep', 'sleep_for') else None,
                    'added': 'node' if stands_at.startswith('spin') and _is_executor_empty(place[0]) else None,
                }
                file, line = place
                yield found('node', fact.data['node'], file=file, line=line, time_s=started[fact.data['node']], **facts)


def _is_executor_empty(file: str | None) -> bool:
    """Return whether a program creates an executor, but adds no node to it."""
    calls = {name_of_call(node) for node in walked(tree)} if (tree := script_of(file)) is not None else set()
    return any(name.endswith('Executor') for name in calls) and 'add_node' not in calls


BLOCKING = ('wait_for_service', 'wait_for_server', 'wait_for_message', 'private_input', 'readline', 'read')


def _waits_for_somebody(data: dict[str, object]) -> bool:
    """Return whether a program waits in `wait_for_service` or `input()`. Another rule reports this cause."""
    return str(data.get('calls', '')).partition('.')[2] in BLOCKING


def _programs_that_ask(recording: Recording) -> set[str | None]:
    """Return the processes that waited for the keyboard. Ctrl-C may have ended this wait before the end of the run."""
    return {fact.process for fact in recording.facts if fact.kind == 'waits for input'}


@rule(
    'programs.ended-at-once',
    what=(
        'the program of {node} ended immediately, so its callback never received the messages on {topics}',
        'the program of {node} ended immediately, so its timer never ran',
    ),
    why='the program and its node end when main() returns',
    do='call rclpy.spin(node) at the end of main(), before rclpy.shutdown()',
    lesson=LESSON,
    level='error',
)
def ended_at_once(recording: Recording) -> Iterator[Finding]:
    """Report a program that ended with exit code 0 within a second, if its node never spun."""
    processes = {process.name: process for process in recording.processes}
    started = {node.name: node.started_s for node in recording.nodes}
    for fact in recording.facts:
        process = processes.get(fact.process or '')
        if fact.kind != 'node not spun' or process is None or process.returncode != 0 or process.ended_s is None:
            continue
        if process.ended_s - started.get(fact.data['node'], 0.0) < SECOND and (fact.data['timers'] or fact.data['topics']):
            file, line = process.origin or (None, None)
            yield found('node', fact.data['node'], file=file, line=line, time_s=process.ended_s, topics=fact.data['topics'])


@rule(
    'messages.not-taken',
    what='{node} is too slow for {topic}: {messages} messages are waiting, the oldest for {age_s} s',
    why='when the queue is full, ROS 2 drops the oldest message without a warning',
    do='remove sleeps and loops from the callback of {topic}, or publish less often; the queue holds {depth}',
    lesson=LESSON,
)
def not_taken(recording: Recording) -> Iterator[Finding]:
    """Report messages for a student's node that no callback processed before the end of the run or of the node.

    Other rules report a node that never spins, or that waits for the keyboard.
    """
    unspun = {fact.data['node'] for fact in recording.facts if fact.kind == 'node not spun'}
    asking = _programs_that_ask(recording)
    unspun |= {node.name for node in recording.nodes if node.process in asking}
    for fact in recording.facts:
        if fact.kind == 'messages wait' and fact.data['node'] not in unspun and fact.data['topic'] != '/parameter_events':
            file, line = end_place(recording, 'subscription', fact.data['topic'], fact.data['node'])
            age_s = round(fact.time_s - fact.data['since_s'], 1)
            facts = {'messages': fact.data['messages'], 'depth': fact.data['depth'], 'age_s': age_s, 'node': fact.data['node']}
            is_full = fact.data['messages'] == fact.data['depth'] and fact.data['node'] in own_nodes(recording)
            if age_s >= SECOND or is_full:
                yield found('topic', fact.data['topic'], file=file, line=line, time_s=fact.data['since_s'], **facts)


@rule(
    'messages.reply-not-taken',
    what='{node} called {service} and the reply arrived, but {node} never read it',
    why='a node receives replies only while it spins, so a loop that only checks future.done() never ends',
    do='spin until the reply arrives: rclpy.spin_until_future_complete(node, future)',
    lesson='13_large_project',
    level='error',
    hides=('programs.never-spun',),
)
def reply_not_taken(recording: Recording) -> Iterator[Finding]:
    """Report a reply that arrived at least a second before the end of the run, and that the client has not processed."""
    for fact in recording.facts:
        if fact.kind == 'reply waits':
            node, service = fact.data['node'], fact.data['service']
            replies = [call.replied_s for call in recording.service_calls if (call.service, call.client) == (service, node)]
            came = [time for time in replies if time is not None]
            if came and fact.time_s - came[-1] >= SECOND:
                file, line = end_place(recording, 'client', service, node)
                yield found('service', service, file=file, line=line, time_s=came[-1], node=node)


@rule(
    'messages.no-server',
    what='{node} uses the {kind_of} {service}, but no node offers it',
    why='a request without a server is lost, and a client that waits for the server waits forever',
    do=(
        "write '{near}' if you mean this name",
        'start the node that offers {service}, or look up the right name with `ros2 {kind_of} list`',
    ),
    lesson='13_large_project',
    level='error',
    hides=('messages.not-taken', 'programs.callback-goes-on'),
)
def no_server(recording: Recording) -> Iterator[Finding]:
    """Report a client that existed for a second without a server.

    A node of edulaunch itself is reported only if it sends a request.
    """
    served, actions, own = names_of(recording, 'service'), _actions(recording), own_nodes(recording)
    asked = {
        (fact.data['node'], fact.data['name']) for fact in recording.facts if fact.kind in ('request lost', 'server awaited')
    }
    parameters = _parameters(recording)
    for end in recording.ends:
        name = end.name.removesuffix(GOAL)
        if (
            end.kind != 'client'
            or recording.duration_s - end.made_s < SECOND
            or '/_action/' in name
            or (end.node, name) in parameters
        ):
            continue
        known = actions if name != end.name else served
        if name not in known and (end.node in own or (end.node, name) in asked):
            file, line = asking_place(recording, end.node, name)
            near = nearest(name, known) or _alike(name, known)
            facts = {'node': speaker(recording, end.node), 'kind_of': 'action' if name != end.name else 'service', 'near': near}
            yield found('service', name, file=file, line=line, time_s=end.made_s, **facts)


GOAL = '/_action/send_goal'


@rule(
    'messages.asked-too-early',
    what='{node} sends a request to {service} {gap_s} s before a node offers it, so the request is lost',
    why='ROS 2 drops a request without a server, so the reply never arrives',
    do='call client.wait_for_service() before you send the request',
    lesson='13_large_project',
    level='error',
)
def asked_too_early(recording: Recording) -> Iterator[Finding]:
    """Report a request to a service that did not exist until later."""
    offered: dict[str, float] = {}
    for end in recording.ends:
        if end.kind == 'service':
            offered.setdefault(end.name.removesuffix(GOAL), end.made_s)
    for fact in recording.facts:
        gap_s = offered.get(fact.data.get('name', ''), 0.0) - fact.time_s
        if fact.kind == 'request lost' and gap_s > 0:
            file, line = fact_place(recording, fact)
            facts = {'node': fact.data['node'], 'gap_s': round(gap_s, 3)}
            yield found('service', fact.data['name'], file=file, line=line, time_s=fact.time_s, **facts)


def _alike(name: str, known: list[str]) -> str | None:
    """Return the known name with the same last part, or None if there is not exactly one."""
    same = [one for one in known if one.rpartition('/')[2] == name.rpartition('/')[2]]
    return same[0] if len(same) == 1 else None


def _actions(recording: Recording) -> list[str]:
    """Return the names of all actions that had a server."""
    names = (end.name for end in recording.ends if end.kind == 'service' and end.name.endswith(GOAL))
    return list(dict.fromkeys(name.removesuffix(GOAL) for name in names))


def _parameters(recording: Recording) -> set[tuple[str, str]]:
    """Return (node, service name) for each client of a parameter service of an existing node."""
    nodes = tuple(f'{name}/' for name in programs(recording))
    return {(end.node, end.name) for end in recording.ends if end.kind == 'client' and is_ros_own(end.name, nodes)}
