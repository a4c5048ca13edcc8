"""Remappings that change nothing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule
from edulaunch.advice.runs import NOWHERE, is_ros_own
from edulaunch.graph.names import RemapRule, expand_name
from edulaunch.graph.ros_arguments import remap_rule
from edulaunch.graph.rule_reader import RuleError
from edulaunch.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.recording import Recording
    from edulaunch.recording.records import NodeRecord, ProcessRecord

SOON_S = 0.5


@rule(
    'launch.remapping-unused',
    what="the remapping of '{old}' to '{new}' changes nothing: {node} has no topic or service '{old}'",
    why='the first name of a remapping is the one that the node itself uses',
    do=(
        "write '{near}' as the first of the two",
        'use one of the names of {node}: {names}',
        'look for the names of {node} with: ros2 node info {node}',
    ),
    lesson='01_first_launch',
    level='error',
    hides=('messages.other-topic', 'messages.nobody-listens', 'messages.nobody-publishes'),
)
def unused(recording: Recording) -> Iterator[Finding]:
    """No node of the program ever had an end of the new name; programs that ended at once are left out, and remappings of a
    whole group of programs of which one uses it.
    """
    used = _used(recording)
    for process in recording.processes:
        nodes = [node for node in recording.nodes if node.process == process.name]
        if not nodes or (process.ended_s is not None and process.ended_s - process.started_s < SOON_S):
            continue
        node, (file, line) = nodes[0], process.origin or NOWHERE
        names = [name for name in _names(node) if not is_ros_own(name, (f'{node.name}/',))]
        for one in _rules(process):
            if one.match.lstrip('/') not in ('tf', 'tf_static') and one.match not in used:
                facts = {'old': one.match, 'new': one.replacement, 'near': _near(node, one, names), 'names': names[:8]}
                yield found('node', node.name, file=file, line=line, time_s=node.started_s, **facts)


def _used(recording: Recording) -> set[str]:
    """The first names of all remappings that some node of their program has used."""
    nodes: dict[str, list[NodeRecord]] = {}
    for node in recording.nodes:
        nodes.setdefault(node.process, []).append(node)
    return {
        one.match
        for process in recording.processes
        for one in _rules(process)
        if any(_has(node, one) for node in nodes.get(process.name, ()))
    }


def _near(node: NodeRecord, rule: RemapRule, names: list[str]) -> str | None:
    namespace, _, name = node.name.rpartition('/')
    old = expand_name(rule.match, name, namespace or '/')
    near = nearest(old, names)
    tail = old.rpartition('/')[2]
    return near or next((name for name in names if name.rpartition('/')[2] == tail), None)


def _rules(process: ProcessRecord) -> Iterator[RemapRule]:
    """Those of its command line that are for topics and services."""
    for flag, text in zip(process.argv, process.argv[1:], strict=False):
        if flag in ('-r', '--remap'):
            try:
                rule = remap_rule(text)
            except RuleError:
                continue
            if rule.kind not in ('node', 'namespace'):
                yield rule


def _has(node: NodeRecord, rule: RemapRule) -> bool:
    """Whether the node has an end of the rule's new name, or the rule is for another node."""
    namespace, _, name = node.name.rpartition('/')
    if rule.node_name not in (None, name):
        return False
    new = expand_name(rule.replacement, name, namespace or '/')
    return any(one == new or one.startswith(f'{new}/_action/') for one in _names(node))


def _names(node: NodeRecord) -> list[str]:
    ends = (*node.publishers, *node.subscriptions, *node.services, *node.clients)
    return list(dict.fromkeys(name for name, _ in ends))
