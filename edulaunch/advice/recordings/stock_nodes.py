"""Rules about values that made a program of ROS 2 end: parameters of a wrong type, and robot descriptions.

The rules read the last lines of the program's output.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import launch_scripts
from edulaunch.advice.runs import origin_place
from edulaunch.engine.nearest import nearest_spelling

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import ProcessRecord

_TYPE = re.compile(
    r"parameter '(?P<name>[^']+)' has invalid type: Wrong parameter type, parameter \{.*\} is of type \{(?P<expected>\w+)\}, "
    r'setting it to \{(?P<given>\w+)\} is not allowed'
)
_XML_COMMENT = re.compile(r'<!--.*?-->', re.DOTALL)
_NUMBER = re.compile(r'-?\d+(?:\.\d+)?')


def _printed(recording: Recording) -> Iterator[tuple[ProcessRecord, str]]:
    """Yield each program that ended with an error, and the content of its standard error."""
    for process in recording.processes:
        if process.package and process.returncode not in (None, 0, -2, -15):
            yield process, ''.join(row.text for row in recording.output if row.process == process.name and row.stream == 'stderr')


@rule(
    'programs.value-of-other-type',
    what=(
        "the parameter '{parameter}' of {node} is of type {expected}, but this value is of type {given}: {value}",
        "the parameter '{parameter}' of {node} is of type {expected}, but its value is of type {given}",
    ),
    why='ROS 2 does not convert the value to the type of the parameter, so the program ends',
    do=(
        'write {meant}',
        "write LaunchConfiguration('{argument}') in place of the string '{argument}'",
        'write a value of type {expected}',
    ),
    lesson='03_parameters',
    level='error',
    hides=('programs.died', 'programs.parameter-not-declared', 'messages.nobody-publishes', 'messages.nobody-listens'),
)
def value_of_other_type(recording: Recording) -> Iterator[Finding]:
    """Report a parameter value that a program of ROS 2 rejected at its start, such as the string '200' for an integer."""
    for process, printed in _printed(recording):
        match = _TYPE.search(printed)
        if match is None:
            continue
        given = next(
            (
                fact.data
                for fact in recording.facts
                if (fact.kind, fact.process, fact.data.get('parameter'))
                == ('parameter not declared', process.name, match['name'])
            ),
            {},
        )
        file, line = origin_place(recording, process.name, given.get('origin', ''))
        value = given.get('value')
        facts: dict[str, Any] = {'node': given.get('node', process.name), 'value': value, **match.groupdict()}
        facts['meant'] = None if value is None else _meant(str(value), match['expected'])
        facts['argument'] = value if value in [each.name for each in recording.launch.declared] else None
        facts['parameter'] = facts.pop('name')
        yield found('process', process.name, file=file, line=line, time_s=process.ended_s, **facts)


def _meant(value: str, expected: str) -> str | None:
    """Return the value of the expected type that the student probably meant, or None."""
    inner = value.strip('\'"')
    if expected == 'integer' and _NUMBER.fullmatch(inner):
        return str(round(float(inner)))
    if expected == 'double' and _NUMBER.fullmatch(inner):
        return str(float(inner))
    if expected == 'bool' and inner.lower() in ('true', 'false'):
        return f'{inner.lower()} without quotes ({inner.capitalize()} in Python)'
    return f"'{inner}' in quotes" if expected == 'string' else None


_XML = re.compile(r'Error parsing the robot description: (?P<said>.*)')
_JOINT = re.compile(r"joint\[@name='(?P<joint>[^']*)'\]: Invalid joint type: (?P<given>\S+)")
JOINT_TYPES = ('continuous', 'fixed', 'floating', 'planar', 'prismatic', 'revolute')


def _description(recording: Recording, process: ProcessRecord) -> str:
    """Return the robot_description of a program, or an empty string."""
    nodes = {node.name for node in recording.nodes if node.process == process.name}
    values = (
        row[3]
        for row in recording.rows('parameters')
        if row[1] in nodes and row[2] == 'robot_description' and isinstance(row[3], str)
    )
    return next(values, '')


def _urdf_place(recording: Recording, description: str, sign: str) -> tuple[str, int] | None:
    """Return the file that contains a robot description, and the first line that contains `sign`.

    The file is in the folder of a launch file, or in a folder `urdf`. Return None if there is no such file.
    """
    folders = dict.fromkeys(os.path.dirname(file) for file, _ in launch_scripts(recording))
    for folder in folders:
        for inner in (folder, os.path.join(folder, 'urdf'), os.path.join(os.path.dirname(folder), 'urdf')):
            for name in sorted(os.listdir(inner)) if os.path.isdir(inner) else ():
                path = os.path.join(inner, name)
                if name.endswith(('.urdf', '.xacro', '.xml')) and os.path.getsize(path) < 1_000_000:
                    with open(path, encoding='utf-8', errors='replace') as opened:
                        text = opened.read()
                    if text.strip() == description.strip():
                        before = text.partition(sign)[0] if sign in text else ''
                        return os.path.realpath(path), before.count('\n') + 1
    return None


@rule(
    'launch.xacro-not-processed',
    what='robot_description contains xacro tags such as <{tag}>, which {process} does not understand',
    why='robot_state_publisher reads URDF; the program xacro must turn the tags into URDF first',
    do="write ParameterValue(Command(['xacro ', path]), value_type=str) in place of the content of the file",
    lesson='12_urdf',
    level='error',
    hides=('programs.died', 'launch.joint-type', 'tf.unknown-frame', 'messages.no-joint-states'),
)
def xacro_not_processed(recording: Recording) -> Iterator[Finding]:
    """Report a robot description that still contains elements of xacro, such as `xacro:property`."""
    for process in recording.processes:
        if process.executable == 'robot_state_publisher':
            tag = re.search(r'<(xacro:\w+)', _XML_COMMENT.sub('', _description(recording, process)))
            if tag is not None:
                place: dict[str, Any] = {'file': process.file, 'line': process.line, 'time_s': process.started_s}
                yield found('process', process.name, **place, tag=tag[1])


@rule(
    'launch.sdf-description',
    what='robot_description of {process} is written in SDF, but edulaunch reads only URDF',
    why='with ROS 2, robot_state_publisher can read SDF if the package sdformat_urdf is installed',
    do='run this launch file on a computer where sdformat_urdf is installed, or write the robot in URDF',
    lesson='12_urdf',
    level='info',
    hides=('programs.died', 'tf.unknown-frame', 'messages.no-joint-states'),
)
def sdf_description(recording: Recording) -> Iterator[Finding]:
    """Report a robot description in SDF. Its outermost element is `sdf` instead of `robot`."""
    for process in recording.processes:
        if process.executable == 'robot_state_publisher':
            first = re.search(r'<[A-Za-z]\w*', _XML_COMMENT.sub('', _description(recording, process)))
            if first is not None and first[0] == '<sdf':
                place: dict[str, Any] = {'file': process.file, 'line': process.line, 'time_s': process.started_s}
                yield found('process', process.name, **place)


@rule(
    'launch.joint-type',
    what="the joint '{joint}' of the robot has the type '{given}', which URDF does not have",
    do=("write type='{near}'", 'use one of these types: {types}'),
    lesson='12_urdf',
    level='error',
    hides=('programs.died', 'tf.unknown-frame', 'messages.no-joint-states', 'messages.nobody-publishes'),
)
def joint_type(recording: Recording) -> Iterator[Finding]:
    """Report the type of a joint that robot_state_publisher rejected."""
    for process, printed in _printed(recording):
        match = _JOINT.search(printed)
        if match is not None and _XML.search(printed):
            place = _urdf_place(recording, _description(recording, process), f'type="{match["given"]}"')
            file, line = place or (process.file, process.line)
            facts = {**match.groupdict(), 'near': nearest_spelling(match['given'], JOINT_TYPES), 'types': list(JOINT_TYPES)}
            yield found('process', process.name, file=file, line=line, time_s=process.ended_s, **facts)
