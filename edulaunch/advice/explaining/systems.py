"""Compare systems: the nodes, topics, services and frames that a launch file plans or that a run had.

A plan starts no process. The endpoints of a program come from an earlier run or from its Python source. A program of edulaunch
itself runs for a moment in a separate simulation. All other endpoints are reported as unknown.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from edulaunch.advice.explaining.source_ends import files_of, read_ends
from edulaunch.advice.plan.titles import shown_value
from edulaunch.engine.graph.names import RemapRule, expand_name, fully_qualified_name, is_hidden, remapped_name
from edulaunch.engine.graph.ros_arguments import RosArgumentsError, parse_ros_arguments
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.frames import frame_links
from edulaunch.engine.recording.records import PARAMETER_SERVICES, NodeRecord
from edulaunch.engine.recording.views import view
from edulaunch.engine.underlay_place import underlay_prefix
from edulaunch.ros.sources.missing import source_package
from edulaunch.ros.sources.source_package import module_file
from edulaunch.runtime.session import Session

MOMENT_S = 1.0
QUIET = ('/rosout', '/parameter_events')
KINDS = ('publisher', 'subscription', 'service', 'client')
NOT_KNOWN = 'endpoints not known'
HIDDEN_PARAMETERS = ('use_sim_time', 'start_type_description_service', 'qos_overrides.')
End = tuple[str, str, str]
"""The kind, the absolute name and the type."""


class SystemNode(NamedTuple):
    """A node of a system.

    :ivar program: the package and executable of the node.
    :ivar source: the origin of the node's endpoints: 'run', 'source', 'built-in', or an empty string if they are unknown.
    :ivar unknown: descriptions of the unknown endpoints.
    """

    name: str
    program: str
    source: str
    ends: list[End]
    unknown: list[str]
    parameters: dict[str, Any]


class SystemFrame(NamedTuple):
    """A transform, and the nodes that publish it."""

    parent: str
    child: str
    is_static: bool
    by: list[str]


class System(NamedTuple):
    """The nodes and frames of a launch file's plan or of a run."""

    title: str
    nodes: list[SystemNode]
    frames: list[SystemFrame]

    def lines(self) -> Iterator[str]:
        """Yield a description of the system, line by line."""
        for node in self.nodes:
            yield f'node {node.name}' + (f' ({node.program})' if node.program else '')
            yield from (f'  {words}' for words in _end_words(node))
            yield from (f'  not known: {words}' for words in node.unknown)
        for frame in self.frames:
            yield f'frame {frame.parent} -> {frame.child}{_by(frame)}'


def _by(frame: SystemFrame) -> str:
    return f' ({"static, " if frame.is_static else ""}by {", ".join(frame.by)})'


def _end_words(node: SystemNode) -> list[str]:
    verbs = dict(zip(KINDS, ('publishes', 'subscribes to', 'serves', 'calls'), strict=True))
    return [f'{verbs[kind]} {name}' + (f' [{type}]' if type else '') for kind, name, type in node.ends]


def system_of_run(recording: Recording, title: str = '') -> System:
    """Return all nodes, endpoints and frames that existed during a run."""
    programs = {process.name: _program(process.argv) for process in recording.processes}
    nodes: dict[str, SystemNode] = {}
    for node in recording.nodes:
        if not is_hidden(node.name):
            values = {name: one.value for name, one in recording.parameters(node.name).items()}
            shown = {name: value for name, value in values.items() if not name.startswith(HIDDEN_PARAMETERS)}
            nodes[node.name] = SystemNode(node.name, programs.get(node.process, ''), 'run', _ends_of(node), [], shown)
    name = os.path.basename(recording.launch.file or '') or 'run'
    return System(title or name, list(nodes.values()), _frames(recording))


def _frames(recording: Recording) -> list[SystemFrame]:
    links = frame_links(recording).values()
    return [SystemFrame(parent, link.child, link.is_static, link.broadcasters) for link in links for parent in link.parents]


def _program(argv: Sequence[str]) -> str:
    words = argv[:1] if argv and os.sep in argv[0] else argv[2:4]
    return ' '.join(os.path.basename(word) for word in words)


def _ends_of(node: NodeRecord) -> list[End]:
    rows = (node.publishers, node.subscriptions, node.services, node.clients)
    return [
        (kind, name, type)
        for kind, part in zip(KINDS, rows, strict=True)
        for name, type in part
        if name not in QUIET and name.rpartition('/')[2] not in PARAMETER_SERVICES and '/_' not in name
    ]


def planned_system(plan: Mapping[str, Any], index: Index, earlier: Recording | None = None, title: str = '') -> System:
    """Return the nodes, endpoints and frames that the plan of a launch file would start.

    :param plan: the plan in plan format 1.
    :param index: the index of the packages.
    :param earlier: the recording of an earlier run, whose nodes determine the endpoints, or None.
    :param title: the title of the system.
    """
    items = [item for item in plan['items'] if item['kind'] == 'node']
    run = None if earlier is None else system_of_run(earlier)
    before = {node.name: node for node in run.nodes} if run is not None else {}
    built_in = [
        item for item in items if item['runtime_name'] not in before and index.prefix(item['package']) == underlay_prefix()
    ]
    moment = _moment(built_in)
    nodes, frames = [], [frame for frame in (run.frames if run else ()) if set(frame.by) <= set(before)]
    for item in items:
        if item['runtime_name'] in before:
            nodes.append(before[item['runtime_name']])
            continue
        found, its_frames = moment.get(item['index']) or _read(item, index)
        nodes.append(found._replace(program=f'{item["package"]} {item["executable"]}', parameters=item['parameters']))
        frames += its_frames
    for item in plan['items']:
        for one in item['nodes'] if item['kind'] == 'load_composable_nodes' else ():
            name = fully_qualified_name(one['namespace'] or '/', one['name'] or one['plugin'].rpartition('::')[2])
            nodes.append(before.get(name) or _unknown(name, f'{one["package"]} {one["plugin"]}'))
    return System(title or os.path.basename(plan['file']), nodes, _merged(frames))


def _merged(frames: list[SystemFrame]) -> list[SystemFrame]:
    found: dict[tuple[str, str], SystemFrame] = {}
    for frame in frames:
        known = found.setdefault((frame.parent, frame.child), frame)
        found[frame.parent, frame.child] = known._replace(by=list(dict.fromkeys([*known.by, *frame.by])))
    return list(found.values())


def _unknown(name: str, program: str = '') -> SystemNode:
    return SystemNode(name, program, '', [], [NOT_KNOWN], {})


Found = tuple[SystemNode, list[SystemFrame]]


def _moment(items: list[dict[str, Any]]) -> dict[int, Found]:
    """Run programs of edulaunch for a moment in a separate simulation, with the arguments of the plan.

    Return what they created.
    """
    if not items:
        return {}
    with Session(env={}) as session:
        for item in items:
            argv = ('ros2', 'run', item['package'], item['executable'], *_words(item))
            session.host.start(ProcessSpec(argv=argv, name=str(item['index'])))
        session.run(MOMENT_S)
        recording = session.recording()
    frames = _frames(recording)
    found: dict[int, Found] = {}
    for node in recording.nodes:
        number = int(node.process.partition('-')[0])
        if number not in found and not is_hidden(node.name):
            known = SystemNode(node.name, '', 'built-in', _ends_of(node), [], {})
            found[number] = known, [frame._replace(by=[node.name]) for frame in frames if node.name in frame.by]
    return found


def _words(item: Mapping[str, Any]) -> list[str]:
    words = [*item['arguments'], '--ros-args']
    for rule, value in (('__node', item['name']), ('__ns', item['namespace'])):
        words += ['-r', f'{rule}:={value}'] if value else []
    for old, new in item['remappings']:
        words += ['-r', f'{old}:={new}']
    for name, value in item['parameters'].items():
        words += ['-p', f'{name}:={json.dumps(value)}']
    return words


def _read(item: Mapping[str, Any], index: Index) -> Found:
    """Return the node and the frames that the source of a student's program defines."""
    unnamed = fully_qualified_name(item['namespace'] or '/', item['name'] or item['executable'].removesuffix('.py'))
    files = source_files(index, item['package'], item['executable'])
    if not files:
        return _unknown(unnamed), []
    read = read_ends(files, item['parameters'])
    name, namespace, rules = item['name'] or read.name, item['namespace'] or '/', _rules(item)
    full = fully_qualified_name(namespace, name) if name else unnamed
    ends = [(kind, _resolved(end, kind, rules, full), type) for kind, end, type in read.ends]
    frames = [SystemFrame(parent, child, is_static, [full]) for parent, child, is_static in read.frames]
    unknown = [*([] if name else ['the name of the node']), *read.unknown]
    return SystemNode(full, '', 'source', ends, unknown, {}), frames


def source_files(index: Index, package: str, executable: str) -> list[str]:
    """Return the Python files of a student's program. Return an empty list for any other program."""
    path = _file_of(index, package, executable)
    return files_of(path) if path is not None and path.endswith('.py') else []


def _file_of(index: Index, package: str, executable: str) -> str | None:
    found = source_package(index, package)
    entry = None if found is None else found.contents.entry_points.get(f'lib/{package}/{executable}')
    if found is None or entry is None:
        return None if found is None else found.contents.files.get(f'lib/{package}/{executable}')
    return module_file(found, entry[0])


def _rules(item: Mapping[str, Any]) -> Sequence[RemapRule]:
    try:
        return parse_ros_arguments(item['cmd'][len(item['prefix']) :], lambda path: ()).remap_rules
    except RosArgumentsError:
        return ()


def _resolved(name: str, kind: str, rules: Sequence[RemapRule], node: str) -> str:
    namespace, _, base = node.rpartition('/')
    what = 'topic' if kind in ('publisher', 'subscription') else 'service'
    try:
        return remapped_name(rules, what, expand_name(name, base, namespace or '/'), base, namespace or '/')
    except ValueError:
        return name


class Difference(NamedTuple):
    """One difference between two systems.

    :ivar sign: '-' if only the first system has it, '+' if only the second system has it, '~' if it differs between the
        systems.
    :ivar node: the name of the node that differs, or an empty string for a frame.
    :ivar parameter: the name of the parameter that differs, or an empty string.
    """

    sign: str
    node: str
    text: str
    parameter: str = ''


def differences(before: System, after: System) -> list[Difference]:
    """Return the differences in nodes, endpoints, parameters and frames, in this order."""
    old, new = ({node.name: node for node in system.nodes} for system in (before, after))
    found = [Difference('-', name, f'node {name} ({old[name].program})') for name in old if name not in new]
    found += [Difference('+', name, f'node {name} ({new[name].program})') for name in new if name not in old]
    for name in (name for name in old if name in new):
        found += _of_node(old[name], new[name])
    first, second = ({(frame.parent, frame.child): frame for frame in system.frames} for system in (before, after))
    for sign, mine, other in (('-', first, second), ('+', second, first)):
        found += [Difference(sign, '', f'frame {key[0]} -> {key[1]}{_by(mine[key])}') for key in mine if key not in other]
    return found


def _of_node(before: SystemNode, after: SystemNode) -> Iterator[Difference]:
    name = before.name
    if before.program != after.program:
        yield Difference('~', name, f'{name} is {after.program}, before {before.program}')
    for sign, one, other in (('-', before, after), ('+', after, before)):
        words = _end_words(other)
        yield from (Difference(sign, name, f'{name} {end}') for end in _end_words(one) if end not in words)
    for key in dict.fromkeys([*before.parameters, *after.parameters]):
        values = [shown_value(node.parameters[key]) if key in node.parameters else 'not set' for node in (before, after)]
        if values[0] != values[1]:
            yield Difference('~', name, f'{name} parameter {key} = {values[1]}, before {values[0]}', key)


def changed_parameters(found: list[Difference]) -> dict[str, list[str]]:
    """Return the names of the changed parameters, by the name of the node."""
    changed: dict[str, list[str]] = {}
    for one in found:
        if one.sign == '~':
            changed.setdefault(one.node, []).extend([one.parameter] if one.parameter else [])
    return changed


def run_differences(before: Recording, after: Recording) -> list[str]:
    """Return the other differences between two runs, one line for each.

    These differences concern the launch arguments, the exit codes, the number of messages of each topic, and the advice.
    """
    found: list[str] = []
    tables: list[tuple[str, list[dict[str, str]]]] = [
        ('argument', [dict(run.launch.arguments) for run in (before, after)]),
        ('exit code of', [_codes(run) for run in (before, after)]),
        ('messages on', [_counts(run) for run in (before, after)]),
    ]
    for what, (old, new) in tables:
        for key in dict.fromkeys([*old, *new]):
            if old.get(key) != new.get(key) and (what != 'exit code of' or (key in old and key in new)):
                found.append(f'~ {what} {key}: {new.get(key, "none")}, before {old.get(key, "none")}')
    for sign, mine, other in (('-', before.warnings, after.warnings), ('+', after.warnings, before.warnings)):
        found += [f'{sign} advice: {text}' for text in mine if text not in other]
    return found


def _codes(run: Recording) -> dict[str, str]:
    """Return the exit codes of processes with nodes, by the name of the process's first node."""
    codes = {one.name: 'none, it runs' if one.returncode is None else str(one.returncode) for one in run.processes}
    owners = {node.process: node.name for node in reversed(run.nodes)}
    return {name: codes[process] for process, name in owners.items() if process in codes}


def _counts(run: Recording) -> dict[str, str]:
    return {one.name: str(one.count) for one in run.topics.values() if one.name not in QUIET and '/_' not in one.name}


def pictured(before: System, after: System, *, services: bool = False) -> Any:
    """Return a picture of two systems side by side (see :func:`edulaunch.canvas.plot_system`)."""
    return view('plot_system')(before, after, changed_parameters(differences(before, after)), services=services)
