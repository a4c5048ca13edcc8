"""Makes decoys of a solution from a recording of the solution."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator, Mapping
from itertools import groupby
from typing import TYPE_CHECKING, Any

from ..evidence import written_text
from .player import LAUNCH, PLAYER, SWAPPED

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord

    from ..submission import Submission

MOST_BYTES = 500_000
"""Largest size of a plan, because the text of a launch file has a limit. In a longer run, a decoy plays every second message,
or every fourth ...
"""
KINDS = ('names', 'replay', 'swapped', 'own programs')
OF_RCLPY = ('/rosout', '/parameter_events')


def decoys(submission: Submission, recording: Recording, folder: str) -> Iterator[tuple[str, str]]:
    """Write the decoys of a solution into a folder, and yield (kind, path of the submission).

    - ``names`` has nodes with the same names, parameters and endpoints in one program that publishes nothing.
    - ``replay`` has the same nodes, which publish and print the recorded messages and lines of the first run.
    - ``swapped`` has the solution's own actions. Each Node and each command `python3 ...` runs an idle program.
    - ``own programs`` is a copy of the package whose programs publish and print the recorded messages and lines.

    :param recording: the recording of the solution's first run.
    """
    name = submission.exercise
    for kind, plays in (('names', False), ('replay', True)):
        program = PLAYER.format(plan=_fitting(recording, plays))
        text = LAUNCH.format(arguments=_defaults(recording), program=program)
        yield kind, _written(os.path.join(folder, kind.replace(' ', '_'), f'{name}.launch.py'), text)
    if submission.file.endswith('.py'):
        target = _copied(submission, os.path.join(folder, 'swapped'))
        with open(_launch_file(submission, target), 'a', encoding='utf-8') as file:
            file.write(SWAPPED)
        yield 'swapped', target
    if submission.package is not None:
        target = _copied(submission, os.path.join(folder, 'own_programs'))
        if _replace_programs(target, submission.package.name, recording):
            yield 'own programs', target


def _fitting(recording: Recording, plays: bool, processes: frozenset[str] | None = None) -> str:
    """Return a plan as JSON that is short enough for a launch file. If necessary, leave out messages."""
    step = 1
    while len(text := json.dumps(plan(recording, plays, processes, step))) > MOST_BYTES and step < 1 << 20:
        step *= 2
    return text


def plan(recording: Recording, plays: bool, processes: frozenset[str] | None = None, step: int = 1) -> dict[str, Any]:
    """Return the actions of a decoy as plain data.

    :param plays: whether the decoy also publishes and prints.
    :param processes: the names of the processes that the decoy replaces, or None for all processes.
    :param step: 1 to publish every message, 2 to publish every second message, and so on.
    """
    nodes = [node for node in recording.nodes if processes is None or node.process in processes]
    entries = [
        _entry(recording, node, step if plays else 0) for node in nodes if not node.name.rpartition('/')[2].startswith('_')
    ]
    lines = [
        [output.time_s, output.text]
        for output in recording.output
        if plays and output.process != 'launch' and (processes is None or output.process in processes)
    ]
    return {'nodes': entries, 'lines': lines, 'arguments': dict(recording.launch.arguments)}


def _entry(recording: Recording, node: NodeRecord, step: int) -> dict[str, Any]:
    namespace, _, name = node.name.rpartition('/')
    publishers = [end for end in node.publishers if end[0] not in OF_RCLPY]
    return {
        'name': name,
        'namespace': namespace,
        'parameters': {key: found.value for key, found in recording.parameters(node.name).items() if key != 'use_sim_time'},
        'publishers': publishers,
        'subscriptions': [end for end in node.subscriptions if end[0] not in OF_RCLPY],
        'messages': sorted(_messages(recording, node.name, publishers, step), key=lambda row: row[0]) if step else [],
    }


def _messages(recording: Recording, node: str, publishers: list[tuple[str, str]], step: int) -> Iterator[list[Any]]:
    for topic, kind in publishers:
        sent = [(time_ns, wire) for time_ns, sender, wire in recording.published(topic, kind) if sender == node]
        cls = recording.message_class(kind)
        for time_ns, wire in sent[::step]:
            yield [time_ns / 1e9, topic, _plain(cls.from_wire(wire))]


def _plain(value: Any) -> Any:
    """Return a value of a message as plain data."""
    if hasattr(value, 'get_fields_and_field_types'):
        return {name: _plain(getattr(value, name)) for name in value.get_fields_and_field_types()}
    if isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, bytes):
        return list(value)
    return [_plain(item) for item in value]


def _defaults(recording: Recording) -> Mapping[str, str]:
    return {argument.name: written_text(argument.default or '') for argument in recording.launch.declared}


def _written(path: str, text: str) -> str:
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)
    return path


def _copied(submission: Submission, folder: str) -> str:
    source = submission.file if submission.package is None else submission.package.path
    target = os.path.join(folder, os.path.basename(source))
    if submission.package is None:
        os.makedirs(folder, exist_ok=True)
        shutil.copy(source, target)
    else:
        shutil.copytree(source, target, ignore=shutil.ignore_patterns('__pycache__'))
    return target


def _launch_file(submission: Submission, target: str) -> str:
    if submission.package is None:
        return target
    return os.path.join(target, os.path.relpath(submission.file, submission.package.path))


def _replace_programs(target: str, package: str, recording: Recording) -> bool:
    """Replace each module of a package that one of its programs runs with a player. Return whether there was such a module."""
    own = sorted((process.executable or '', process.name) for process in recording.processes if process.package == package)
    written = False
    for executable, names in groupby(own, key=lambda pair: pair[0]):
        plays = _fitting(recording, True, frozenset(name for _, name in names))
        for path in _modules(target, package, executable):
            _written(path, PLAYER.format(plan=plays))
            written = True
    return written


def _modules(target: str, package: str, executable: str) -> Iterator[str]:
    """Yield the files of the modules that the entry point `executable` in setup.py names. Otherwise, yield `executable`.py."""
    is_named = False
    try:
        with open(os.path.join(target, 'setup.py'), encoding='utf-8') as file:
            lines = [line.split('=') for line in file.read().replace('"', "'").split("'") if '=' in line and ':' in line]
    except OSError:
        return
    for name, *rest in lines:
        if name.strip() == executable:
            is_named = True
            yield os.path.join(target, *rest[0].partition(':')[0].strip().split('.')) + '.py'
    usual = os.path.join(target, package, f'{executable}.py')
    if not is_named and os.path.isfile(usual):
        yield usual
