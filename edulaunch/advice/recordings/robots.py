"""Rules about robot descriptions, joints, and bags that record topics that do not exist."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.runs import ends_by_name, node_place, speaker
from edulaunch.engine.nearest import nearest, nearest_name

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import ProcessRecord


def _place(process: ProcessRecord) -> dict[str, Any]:
    return {'file': process.file, 'line': process.line, 'time_s': process.started_s}


@rule(
    'messages.bag-of-nothing',
    what='{process} records {topic}, but no node publishes on this topic, so the bag has no messages from this topic',
    do=('record {near} if you mean that topic', 'look up the name of the topic with `ros2 topic list`'),
    lesson='15_bags',
    level='error',
)
def bag_of_nothing(recording: Recording) -> Iterator[Finding]:
    """Report topics on the command line of `ros2 bag record` that have no publisher."""
    ends = ends_by_name(recording)
    sent = [name for kind, name in ends if kind == 'publisher']
    for process in recording.processes:
        if process.argv[1:3] != ['bag', 'record'] or not process.argv[0].endswith('ros2'):
            continue
        for option, word in zip(process.argv[2:], process.argv[3:], strict=False):
            topic = word if word.startswith('/') else f'/{word}'
            is_named = topic == word or ('subscription', topic) in ends
            if (
                is_named
                and topic not in sent
                and not os.path.exists(word)
                and not word.startswith('-')
                and not option.startswith('-')
            ):
                yield found('topic', topic, **_place(process), process=process.name, near=nearest_name(topic, sent))


@rule(
    'launch.description-is-path',
    what='robot_description is {given}, but {process} needs the content of the URDF file, not its path',
    why='{process} does not open files, so the parameter must contain the XML itself',
    do="read the file with open(path).read(), or use ParameterValue(Command(['xacro ', path]), value_type=str)",
    lesson='12_urdf',
    level='error',
    hides=('programs.died',),
)
def description_is_path(recording: Recording) -> Iterator[Finding]:
    """Report a robot_description that is the name of a URDF file instead of its content."""
    for process in recording.processes:
        if process.executable == 'robot_state_publisher':
            for text in _texts(recording, process):
                if re.search(r'\.(urdf|xacro|xml)\s*$', text) and '<' not in text:
                    yield found('process', process.name, **_place(process), given=f"'{text.strip()[-60:]}'")


def _texts(recording: Recording, process: ProcessRecord) -> Iterator[str]:
    """Yield the values of a program's parameter robot_description.

    They come from its node, or from its command line if the program ended before it created the node.
    """
    for _, node, name, value, _ in recording.rows('parameters'):
        if (
            name == 'robot_description'
            and isinstance(value, str)
            and node in {one.name for one in recording.nodes if one.process == process.name}
        ):
            yield value
    for words in zip(process.argv, process.argv[1:], strict=False):
        if words[0] == '-p' and words[1].startswith('robot_description:='):
            yield words[1].partition(':=')[2].strip('\'"')
        elif words[0] == '--params-file':
            yield from _in_file(words[1])


def _in_file(path: str) -> Iterator[str]:
    """Yield the robot_description in a parameter file.

    Yield nothing for a temporary file, which no longer exists after the run.
    """
    if os.path.isfile(path) and os.path.getsize(path) < 100_000:
        with open(path, encoding='utf-8', errors='replace') as file:
            yield from re.findall(r'robot_description: *[\'"]?([^\'"\n<]+)', file.read())


MOVABLE = re.compile(
    r'<joint\b[^>]*?\bname="([^"]+)"[^>]*?\btype="(?:revolute|continuous|prismatic)"|'
    r'<joint\b[^>]*?\btype="(?:revolute|continuous|prismatic)"[^>]*?\bname="([^"]+)"'
)


def _movable(recording: Recording) -> Iterator[tuple[str, list[str]]]:
    """Yield each robot_state_publisher with the movable joints of its robot. Skip joints that mimic another joint."""
    for node in recording.nodes:
        described = (
            recording.parameters(node.name).get('robot_description')
            if any(name.endswith('joint_states') for name, _ in node.subscriptions)
            else None
        )
        if described is not None and isinstance(described.value, str):
            joints = [first or second for first, second in MOVABLE.findall(described.value)]
            if joints and '<mimic' not in described.value:
                yield node.name, joints


@rule(
    'messages.no-joint-states',
    what=(
        '{node} expects the angles of the joints on {topic}, but {other} publishes them on {elsewhere}',
        'the robot description has movable joints ({joints}), but no node publishes on {topic}',
    ),
    why='without the angle of a joint, the frames after that joint have no position in tf',
    do=(
        "start both nodes in one namespace: give {other} namespace='{space}'",
        'start both nodes in one namespace, or remap {elsewhere} to {topic}',
        'start joint_state_publisher if there is no real robot: '
        "Node(package='joint_state_publisher', executable='joint_state_publisher')",
    ),
    lesson='12_urdf',
    hides=('messages.nobody-publishes', 'messages.other-topic'),
)
def no_joint_states(recording: Recording) -> Iterator[Finding]:
    """Report a robot_state_publisher that existed for a second while no node published joint states.

    Skip nodes that launch files of ROS packages start.
    """
    ours = tuple(os.path.join(path, '') for path, name in recording.rows('roots') if name == '@underlay')
    ends = ends_by_name(recording)
    lived = {node.name: node.started_s for node in recording.nodes}
    for node, joints in _movable(recording):
        topic = next(
            end.name
            for end in recording.ends
            if end.node == node and end.kind == 'subscription' and end.name.endswith('joint_states')
        )
        file, line = node_place(recording, node)
        is_ours = file is not None and file.startswith(ours)
        if ('publisher', topic) not in ends and recording.duration_s - lived[node] >= 1.0 and not is_ours:
            others = [end for end in recording.ends if end.kind == 'publisher' and end.type == JOINT_STATE]
            facts: dict[str, Any] = {'node': node, 'joints': joints}
            if others:
                facts |= {
                    'other': speaker(recording, others[0].node),
                    'elsewhere': others[0].name,
                    'space': topic.rpartition('/')[0].strip('/') or None,
                }
                file, line = node_place(recording, others[0].node)
            yield found('topic', topic, file=file, line=line, **facts)


JOINT_STATE = 'sensor_msgs/msg/JointState'


@rule(
    'messages.other-joint',
    what=(
        "{node} publishes the state of a joint '{joint}' that the robot does not have (joints of the robot: {joints})",
        '{node} publishes {names} names but {positions} positions of joints on {topic}',
    ),
    why='robot_state_publisher ignores joints that are not in its URDF, so frames after a missing joint have no position in tf',
    do=(
        "write '{near}'",
        'write one number into message.position for each of the {names} names',
        'use the names in the URDF: {joints}',
    ),
    lesson='12_urdf',
    level='error',
)
def other_joint(recording: Recording) -> Iterator[Finding]:
    """Report the last message of a node on joint_states if it names unknown joints.

    Also report the message if the numbers of positions and names differ.
    """
    for state_publisher, joints in _movable(recording):
        for topic in dict.fromkeys(
            end.name for end in recording.ends if end.node == state_publisher and end.name.endswith('joint_states')
        ):
            last = {node: message for (_, node, message) in recording.published(topic, JOINT_STATE)}
            for node, wire in last.items():
                names, positions = list(wire[-4]), list(wire[-3])
                file, line = node_place(recording, node)
                place: dict[str, Any] = {'file': file, 'line': line, 'node': speaker(recording, node)}
                unknown = [name for name in names if name not in joints]
                if len(names) != len(positions):
                    yield found('topic', topic, **place, names=len(names), positions=len(positions))
                elif unknown and not set(joints) & set(names):
                    facts = {'joint': unknown[0], 'joints': joints, 'near': nearest(unknown[0], joints)}
                    yield found('topic', topic, **place, **facts)
