"""Rules about parameter values that never reached a node, and launch arguments that no launch file declares."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.recordings.programs import ENDED_WELL
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import node_place, origin_place, passed_file
from edulaunch.engine.nearest import nearest, nearest_spelling
from edulaunch.engine.recording.records import Fact, UnreadArgument

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LESSON = '13_large_project'
SET = 'rcl_interfaces/srv/SetParameters'


@rule(
    'programs.parameter-not-declared',
    what="{node} does not declare the parameter '{parameter}', so ROS 2 ignores the value {value}",
    why='a node accepts only the parameters that it declares, and ROS 2 drops all others without a warning',
    do=(
        "write '{near}' if you mean this name",
        "declare it with self.declare_parameter('{parameter}', ...), or set one of the parameters that {node} "
        'declares: {declared}',
        "declare it in the node: self.declare_parameter('{parameter}', ...)",
    ),
    lesson=LESSON,
    level='error',
)
def not_declared(recording: Recording) -> Iterator[Finding]:
    """Report a parameter value for a node that does not declare the parameter. Skip programs that ended early with an error.

    If the source of the value serves several nodes, skip the value if another node declares the parameter.
    """
    dead = {process.name for process in recording.processes if process.returncode not in ENDED_WELL}
    dead |= {fact.process for fact in recording.facts if fact.kind == 'server awaited' and fact.process}
    dead |= {process.name for process in recording.processes if '/component_container' in process.argv[0]}
    taken = {(parameter, origin) for _, _, parameter, _, origin in recording.rows('parameters')}
    for fact in recording.facts:
        name = fact.data.get('parameter', '')
        if fact.kind == 'parameter not declared' and (name, fact.data['origin']) not in taken and fact.process not in dead:
            file, line = origin_place(recording, fact.process, fact.data['origin'])
            declared = [one for one in fact.data['declared'] if not one.startswith(ROS_PARAMETERS)]
            facts = {'node': fact.data['node'], 'value': fact.data['value'], 'near': nearest(name, declared)}
            yield found('parameter', name, file=file, line=line, declared=declared[:8], **facts)


ROS_PARAMETERS = ('qos_overrides.', 'use_sim_time', 'start_type_description_service')


@rule(
    'programs.key-for-no-node',
    what=(
        'the launch file sets parameters for the node {launched}, but ROS arguments rename this node to {node}',
        '{file} sets no parameter of {nodes}, because its only key is {only}',
        '{file} sets no parameter of {nodes}, because its keys are {keys}',
    ),
    why='ROS 2 compares each key of a parameter file with the full name of the node, and ignores other keys silently',
    do=(
        'remove __node and __ns from the ROS arguments, and set name= and namespace= of {launched} instead',
        'replace the key `{near}` with `{node}` (or with `/**` for all nodes)',
        'write the key `{node}` (or `/**` for all nodes) above `ros__parameters`',
    ),
    lesson='03_parameters',
    level='error',
)
def key_for_no_node(recording: Recording) -> Iterator[Finding]:
    """Report a parameter file whose entries match no node. A dry run does not contain the names that programs choose."""
    passed_over: dict[str, list[Fact]] = {}
    for fact in recording.facts:
        if fact.kind == 'keys for no node':
            passed_over.setdefault(fact.data['file'], []).append(fact)
    containers = {process.name for process in recording.processes if '/component_container' in process.argv[0]}
    for file, facts in passed_over.items():
        without = {fact.data['node'] for fact in facts}
        readers = {
            process.name for process in recording.processes if any(os.path.basename(word) == file for word in process.argv)
        }
        if not readers & containers and all(node.name in without for node in recording.nodes if node.process in readers):
            node, keys, line = facts[0].data['node'], facts[0].data['keys'], max(facts[0].data['line'] - 2, 1)
            near = nearest_spelling(node, keys) or (keys[0] if len(keys) == 1 else None)
            is_made = file.startswith('launch_params_')  # launch generates this file, so the student cannot edit it
            places = node_place(recording, node) if is_made else (passed_file(recording, file), line)
            nodes = list(dict.fromkeys(fact.data['node'] for fact in facts))[:5]
            only = keys[0] if len(keys) == 1 else None
            details = {'node': node, 'nodes': nodes, 'keys': keys[:5], 'only': only, 'near': near}
            details['launched'] = keys[0] if is_made else None
            yield found('file', file, file=places[0], line=places[1], time_s=facts[0].time_s, **details)


@rule(
    'programs.parameter-refused',
    what='{node} rejected a parameter that {asker} tried to set: {reason}',
    why='the parameter keeps its old value, and only the result of set_parameters shows this',
    do='set a value of the type and range that `ros2 param describe {node} {parameter}` prints, and check the result',
    lesson=LESSON,
)
def refused(recording: Recording) -> Iterator[Finding]:
    """Report a value that the node's parameter service rejected."""
    if not any(row[2] == SET for row in recording.rows('calls')):
        return
    for call in recording.service_calls:
        if call.type != SET or call.response is None:
            continue
        for parameter, result in zip(call.request.parameters, call.response.results, strict=False):
            if not result.successful:
                node = call.service.rpartition('/')[0]
                file, line = node_place(recording, call.client)
                facts = {'node': node, 'asker': call.client, 'reason': result.reason}
                yield found('parameter', parameter.name, file=file, line=line, time_s=call.time_s, **facts)


@rule(
    'launch.unknown-argument',
    what="no launch file declares the argument '{argument}', so its value has no effect",
    why='ROS 2 accepts any name:=value and does not report names that no launch file declares',
    do=(
        "write '{near}:=' instead of '{argument}:='",
        'use one of the declared arguments: {declared}',
        "leave it out, or declare it in the launch file: DeclareLaunchArgument('{argument}')",
    ),
    lesson='01_first_launch',
)
def unknown_argument(recording: Recording) -> Iterator[Finding]:
    """Report a launch argument that no launch file declares, unless a launch file reads a configuration with that name."""
    for argument, time_s in _unread(recording):
        if argument.included is None:
            near = nearest(argument.name, argument.declared)
            yield found('argument', argument.name, time_s=time_s, declared=argument.declared, near=near)


@rule(
    'launch.undeclared-in-include',
    what="the argument '{argument}' is passed to {included}, which does not declare it, so it has no effect",
    why='an include accepts any argument, and ROS 2 does not report one that the included file never uses',
    do=(
        "write '{near}' instead of '{argument}'",
        'use one of the arguments that {included} declares: {declared}',
        "leave it out, or declare it in {included}: DeclareLaunchArgument('{argument}')",
    ),
    lesson='13_large_project',
)
def undeclared_in_include(recording: Recording) -> Iterator[Finding]:
    """Report an undeclared argument in the `launch_arguments` of an IncludeLaunchDescription."""
    for argument, time_s in _unread(recording):
        if argument.included is not None:
            yield found(
                'argument',
                argument.name,
                file=argument.file,
                line=argument.line,
                time_s=time_s,
                included=os.path.basename(argument.included),
                declared=argument.declared,
                near=nearest(argument.name, argument.declared),
            )


def _unread(recording: Recording) -> Iterator[tuple[UnreadArgument, float | None]]:
    """Yield the unused launch arguments of the run, and of each `ros2 launch` in a terminal with the time at which it ended."""
    yield from ((argument, None) for argument in recording.launch.unread)
    for fact in recording.facts:
        if fact.kind == 'argument unread':
            yield UnreadArgument(**fact.data), fact.time_s
