"""Rules about endpoints that do not match, remappings without an effect, and nodes with equal names."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import NOWHERE, asking_place, end_place, ends_by_name, is_ros_own, own_nodes, speaker
from edulaunch.engine.graph.names import RemapRule, expand_name
from edulaunch.engine.graph.ros_arguments import remap_rule
from edulaunch.engine.graph.rule_reader import RuleError
from edulaunch.engine.nearest import nearest_spelling

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord, ProcessRecord

LESSON = '09_broadcaster_and_listener'


def _unfit(recording: Recording, *policies: str) -> Iterator[Finding]:
    """Yield a finding for each publisher and subscription that one of these QoS policies makes incompatible."""
    for mismatch in recording.mismatches:
        if mismatch.why in policies:
            file, line = end_place(recording, 'subscription', mismatch.topic, mismatch.subscriber)
            pair = {
                'node': speaker(recording, mismatch.publisher),
                'other': speaker(recording, mismatch.subscriber),
                'policy': mismatch.why,
            }
            yield found('topic', mismatch.topic, file=file, line=line, time_s=mismatch.note.time_s, **pair)


@rule(
    'messages.best-effort',
    what='{node} publishes on {topic} with best-effort reliability, but {other} requires reliable, so {other} receives nothing',
    why='ROS 2 does not connect a subscription to a publisher that offers less than the subscription requires',
    do='use create_subscription(..., qos_profile_sensor_data) in {other}, or publish with reliable',
    lesson=LESSON,
    level='error',
)
def best_effort(recording: Recording) -> Iterator[Finding]:
    """Report a best-effort publisher and a reliable subscription of the same topic."""
    return _unfit(recording, 'RELIABILITY')


@rule(
    'messages.not-kept',
    what='{other} requires transient local messages on {topic}, but {node} publishes volatile ones, so {other} receives nothing',
    why='ROS 2 does not connect a subscription to a publisher that offers less than the subscription requires',
    do=(
        'publish with QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL) in {node}, or keep the '
        'durability of the subscription at VOLATILE'
    ),
    lesson=LESSON,
    level='error',
)
def not_kept(recording: Recording) -> Iterator[Finding]:
    """Report a volatile publisher and a transient-local subscription of the same topic."""
    return _unfit(recording, 'DURABILITY')


@rule(
    'messages.qos',
    what='{node} publishes on {topic}, but {other} receives nothing, because the QoS policy {policy} of the two differs',
    why='ROS 2 does not connect a subscription to a publisher that offers less than the subscription requires',
    do='use the same QoSProfile on both sides, and compare them with `ros2 topic info {topic} --verbose`',
    lesson=LESSON,
    level='error',
)
def quality(recording: Recording) -> Iterator[Finding]:
    """Report a publisher and a subscription whose deadlines or liveliness policies are incompatible."""
    return _unfit(recording, 'DEADLINE', 'LIVELINESS')


@rule(
    'messages.types',
    what='{node} publishes {sent} on {topic}, but {other} expects {heard}, so {other} receives nothing',
    why='ROS 2 connects only publishers and subscriptions of the same type, and reports nothing otherwise',
    do='use the same message type on both sides, or two topics',
    lesson=LESSON,
    level='error',
)
def different_types(recording: Recording) -> Iterator[Finding]:
    """Report a publisher and a subscription with different types, if neither endpoint has another partner on the topic."""
    ends = ends_by_name(recording)
    for mismatch in recording.mismatches:
        if mismatch.why != 'TYPE':
            continue
        publishers, subscriptions = ends['publisher', mismatch.topic], ends['subscription', mismatch.topic]
        sent = {end.type for end in publishers}
        expected = {end.type for end in subscriptions if end.node == mismatch.subscriber}
        offered = {end.type for end in publishers if end.node == mismatch.publisher}
        wanted = {end.type for end in subscriptions}
        if not expected & sent or not offered & wanted:
            is_mine = mismatch.subscriber in own_nodes(recording)
            mine = ('subscription', mismatch.subscriber) if is_mine else ('publisher', mismatch.publisher)
            file, line = end_place(recording, mine[0], mismatch.topic, mine[1])
            pair = {'node': speaker(recording, mismatch.publisher), 'other': speaker(recording, mismatch.subscriber)}
            types = {'sent': sorted(offered), 'heard': sorted(expected)}
            yield found('topic', mismatch.topic, file=file, line=line, time_s=mismatch.note.time_s, **pair, **types)


@rule(
    'messages.service-type',
    what='{node} calls the service {service} with the type {asked}, but its type is {served}',
    why='ROS 2 does not connect a client and a server of different types, so the client waits forever',
    do='import {served}, and use it in the client',
    lesson=LESSON,
    level='error',
)
def service_type(recording: Recording) -> Iterator[Finding]:
    """Report a client whose service exists only with another type."""
    ends = ends_by_name(recording)
    for (kind, name), clients in ends.items():
        servers = ends.get(('service', name))
        if kind != 'client' or not servers:
            continue
        served = {end.type for end in servers}
        for end in clients:
            if end.type not in served:
                file, line = asking_place(recording, end.node, name)
                types = {'asked': end.type, 'served': servers[0].type}
                yield found('service', name, file=file, line=line, time_s=end.made_s, node=speaker(recording, end.node), **types)


SOON_S = 0.5


@rule(
    'launch.remapping-unused',
    what="the remapping of '{old}' to '{new}' has no effect, because {node} has no topic or service '{old}'",
    why='the first name of a remapping is the name that the node uses in its code',
    do=(
        'remove the remapping: {named} is the name of the node, which a remapping of topics does not change',
        "write '{near}' as the first name",
        'use one of the names of {node}: {names}',
        'look up the names of {node} with `ros2 node info {node}`',
    ),
    lesson='01_first_launch',
    level='error',
    hides=('messages.other-topic', 'messages.nobody-listens', 'messages.nobody-publishes'),
)
def unused(recording: Recording) -> Iterator[Finding]:
    """Report a remapping that no node of the program uses. Skip programs that ended immediately.

    Also skip a remapping for a group of programs if one of them uses it.
    """
    used = _used(recording)
    for process in recording.processes:
        nodes = [node for node in recording.nodes if node.process == process.name]
        if not nodes or (process.ended_s is not None and process.ended_s - process.started_s < SOON_S):
            continue
        node, (file, line) = nodes[0], process.origin or NOWHERE
        names = [name for name in _names(node) if not is_ros_own(name, (f'{node.name}/',))]
        for one in remappings(process):
            if one.match.lstrip('/') not in ('tf', 'tf_static') and one.match not in used and one.match != one.replacement:
                named = one.replacement if one.replacement.lstrip('/') == node.name.rpartition('/')[2] else None
                facts = {
                    'old': one.match,
                    'new': one.replacement,
                    'named': named,
                    'near': _own_form(node, one.match, _near(node, one, names)),
                    'names': names[:8],
                }
                yield found('node', node.name, file=file, line=line, time_s=node.started_s, **facts)


def _used(recording: Recording) -> set[str]:
    """Return the original names of all remappings that a node of the remapped program has used."""
    nodes: dict[str, list[NodeRecord]] = {}
    for node in recording.nodes:
        nodes.setdefault(node.process, []).append(node)
    return {
        one.match
        for process in recording.processes
        for one in remappings(process)
        if any(_has(node, one) for node in nodes.get(process.name, ()))
    }


def _own_form(node: NodeRecord, given: str, near: str | None) -> str | None:
    """Return a name as a program may use it: without the namespace of its node, unless this would repeat the given name."""
    namespace = node.name.rpartition('/')[0]
    own = near.removeprefix(f'{namespace}/') if near is not None else None
    return near if own == given else own


def _near(node: NodeRecord, rule: RemapRule, names: list[str]) -> str | None:
    namespace, _, name = node.name.rpartition('/')
    old = expand_name(rule.match, name, namespace or '/')
    near = nearest_spelling(old, names)
    tail = old.rpartition('/')[2]
    return near or next((name for name in names if name.rpartition('/')[2] == tail), None)


def remappings(process: ProcessRecord) -> Iterator[RemapRule]:
    """Yield the remapping rules on a program's command line that apply to topics and services."""
    for flag, text in zip(process.argv, process.argv[1:], strict=False):
        if flag in ('-r', '--remap'):
            try:
                rule = remap_rule(text)
            except RuleError:
                continue
            if rule.kind not in ('node', 'namespace'):
                yield rule


def _has(node: NodeRecord, rule: RemapRule) -> bool:
    """Return whether a node has an endpoint with the new name of a remapping rule."""
    namespace, _, name = node.name.rpartition('/')
    if rule.node_name not in (None, name):
        return False
    new = expand_name(rule.replacement, name, namespace or '/')
    return any(one == new or one.startswith(f'{new}/_action/') for one in _names(node))


def _names(node: NodeRecord) -> list[str]:
    ends = (*node.publishers, *node.subscriptions, *node.services, *node.clients)
    return list(dict.fromkeys(name for name, _ in ends))


@rule(
    'programs.same-name',
    what='two nodes have the name {node}: one in {first} and one in {second}',
    why='parameters and services of {node} have the same names in both, so it is not defined which node answers',
    do=(
        'if you need only one, press Ctrl-C in the terminal where `{command}` is running',
        "rename one of them, for example with name='{other}' in the launch file, or use another namespace",
    ),
    lesson='01_first_launch',
)
def same_name(recording: Recording) -> Iterator[Finding]:
    """Report two nodes that have the same name at the same time.

    Skip a node that was started again after its end, and the nodes of `ros2` commands.
    """
    origins = {process.name: process.origin for process in recording.processes}
    alive: dict[str, tuple[str, float | None]] = {}
    for node in recording.nodes:
        before = alive.get(node.name)
        if before is not None and '/_' not in node.name and (before[1] is None or before[1] > node.started_s):
            file, line = origins.get(node.process) or (None, None)
            other = f'{node.name.rpartition("/")[2]}_2'
            command = recording.beside.get(before[0]) or recording.beside.get(node.process)
            pair = {'first': before[0], 'second': node.process, **({'command': command} if command else {})}
            yield found('node', node.name, file=file, line=line, time_s=node.started_s, other=other, **pair)
        alive[node.name] = (node.process, node.ended_s)
