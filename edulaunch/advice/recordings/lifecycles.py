"""Rules about launch files that name a lifecycle node, a state or a container that does not exist."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import keyword_of, launch_scripts, name_of_call, walked
from edulaunch.engine.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LOAD_NODE = '/_container/load_node'
LESSON = '05_events'
MEANT = {
    'configured': 'inactive',
    'activated': 'active',
    'running': 'active',
    'deactivated': 'inactive',
    'cleaned up': 'unconfigured',
    'cleanedup': 'unconfigured',
    'shutdown': 'finalized',
    'configure': 'configuring',
    'activate': 'activating',
}
"""Words that students write for a state, and the name of that state in ROS 2."""
STATES = (
    *('unconfigured', 'inactive', 'active', 'finalized', 'configuring', 'cleaningup', 'shuttingdown'),
    *('activating', 'deactivating', 'errorprocessing'),
)


@rule(
    'launch.no-container',
    what='LoadComposableNodes waits for the container {container}, which does not exist',
    why='the components start only in a container with exactly this name and namespace',
    do=("write target_container='{near}'", 'start a ComposableNodeContainer with this name first'),
    lesson='13_large_project',
    level='error',
    hides=('messages.no-server', 'launch.component-not-loaded'),
)
def no_container(recording: Recording) -> Iterator[Finding]:
    """Report a launch that loads components into a container that does not exist."""
    served = [end.name for end in recording.ends if end.kind == 'service' and end.name.endswith(LOAD_NODE)]
    containers = [name.removesuffix(LOAD_NODE) for name in served]
    launches = {node.name for node in recording.nodes if node.name.rpartition('/')[2].startswith('launch_ros_')}
    for end in recording.ends:
        if end.kind == 'client' and end.name.endswith(LOAD_NODE) and end.name not in served and end.node in launches:
            wanted = end.name.removesuffix(LOAD_NODE)
            tails = [name for name in containers if name.rpartition('/')[2] == wanted.rpartition('/')[2]]
            near = nearest(wanted, containers) or next(iter(tails or (containers if len(containers) == 1 else [])), None)
            file, line = _loading_line(recording, wanted)
            short = near.removeprefix('/') if near is not None and near.count('/') == 1 else near
            yield found('node', wanted, file=file, line=line, time_s=end.made_s, container=wanted, near=short)


def _loading_line(recording: Recording, container: str) -> tuple[str | None, int | None]:
    """Return the file and line of the LoadComposableNodes that names a container.

    If none names it, return the first line of the only LoadComposableNodes.
    """
    calls = [
        (file, call)
        for file, tree in launch_scripts(recording)
        for call in walked(tree)
        if isinstance(call, ast.Call) and name_of_call(call) == 'LoadComposableNodes'
    ]
    for file, call in calls:
        target = keyword_of(call, 'target_container')
        if isinstance(target, ast.Constant) and container.endswith(str(target.value)):
            return file, target.lineno
    return (calls[0][0], calls[0][1].lineno) if len(calls) == 1 else (recording.launch.file, None)


@rule(
    'launch.no-such-state',
    what="{argument}='{state}' names no state of a lifecycle node, so this event never occurs",
    why='the states are unconfigured, inactive, active and finalized, and those of the transitions, such as configuring',
    do=("write {argument}='{near}'", 'use one of these states: {states}'),
    lesson='14_services',
    level='error',
    hides=('programs.not-activated', 'programs.not-configured'),
    edits=(("{argument}='{state}'", "{argument}='{near}'"),),
)
def no_such_state(recording: Recording) -> Iterator[Finding]:
    """Report OnStateTransition with a literal state that does not exist."""
    for file, tree in launch_scripts(recording):
        for call in walked(tree):
            if not isinstance(call, ast.Call) or name_of_call(call) != 'OnStateTransition':
                continue
            for argument in ('start_state', 'goal_state'):
                value = keyword_of(call, argument)
                if isinstance(value, ast.Constant) and isinstance(value.value, str) and value.value not in STATES:
                    near = MEANT.get(value.value.lower()) or nearest(value.value, STATES)
                    facts: dict[str, Any] = {'argument': argument, 'state': value.value, 'near': near, 'states': list(STATES)}
                    yield found('action', 'OnStateTransition', file=file, line=value.lineno, **facts)


@rule(
    'launch.matches-no-node',
    what="matches_node_name('{written}') matches no node of this launch, so the event changes no state",
    why='the name must be the full name of the node, with its namespace',
    do=("write matches_node_name('{near}')", 'use matches_action(...) with the variable of the LifecycleNode'),
    lesson='14_services',
    level='error',
    hides=('programs.not-activated', 'programs.not-configured'),
    edits=(("'{written}'", "'{near}'"),),
)
def matches_no_node(recording: Recording) -> Iterator[Finding]:
    """Report a matcher with a literal name that no node of the run has."""
    names = [node.name for node in recording.nodes]
    for file, tree in launch_scripts(recording):
        for call in walked(tree):
            if isinstance(call, ast.Call) and name_of_call(call) == 'matches_node_name':
                value = call.args[0] if call.args else keyword_of(call, 'node_name')
                if isinstance(value, ast.Constant) and isinstance(value.value, str):
                    name = value.value if value.value.startswith('/') else f'/{value.value}'
                    tails = [one for one in names if one.rpartition('/')[2] == name.rpartition('/')[2]]
                    if name not in names and names:
                        near = next(iter(tails), None) or nearest(name, names)
                        yield found('action', name, file=file, line=value.lineno, written=value.value, near=near)
