"""Rules about valid messages that do not do what the student intended. The rules compare the numbers in the messages."""

from __future__ import annotations

import linecache
import math
import re
from bisect import bisect_right
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from edulaunch.advice.recordings.matching import remappings
from edulaunch.advice.recordings.topics import lone_ends
from edulaunch.advice.recordings.turtles import WRITTEN, commands, turtles
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import joined_strings, launch_scripts, program_scripts
from edulaunch.advice.runs import (
    NOWHERE,
    Broadcasts,
    broadcast_place,
    broadcasts,
    by_child,
    end_place,
    ends_by_name,
    fact_place,
    own_nodes,
    places,
    programs,
)
from edulaunch.engine.graph.names import expand_name

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import EndRecord

POSE = 'turtlesim/msg/Pose'
LESSON = '09_broadcaster_and_listener'
AT_TURTLE_M = 0.3  # the largest distance between a turtle and its frame, which is a moment late
SAMPLES = 12
"""The number of commands that a follower must have sent before its formula is known."""
CLOSE = 0.05
"""The largest difference between ratios of numbers that follow one formula. A lookup is one broadcast older than the command."""


ORIGIN = (0.0, 0.0, 0.0)
MOVES = 0.1
"""The angle, in radians, by which a leader must move as seen from the origin. A leader that stays reveals nothing about the
lookup.
"""


FAR = 0.98
"""A limit for the cosine of half the angle between heading and rotation. Below this value, the angle is more than 0.4 rad."""


@rule(
    'tf.lookup-swapped',
    what=(
        '{node} steers {turtle} by the position of {fixed} in the frame world, not as seen from {turtle}',
        '{node} steers {turtle} by the position of {turtle} as seen from {leader}, because the frames of '
        'lookup_transform are swapped',
    ),
    why=(
        'lookup_transform(target, source) returns the position of source as seen from target, and the follower must be the target'
    ),
    do="write the frame of the robot that drives first: lookup_transform('{own}', '{other}', ...)",
    lesson=LESSON,
    level='error',
    hides=('turtlesim.wall', 'turtlesim.slow-commands', 'messages.two-commanders'),
)
def lookup_swapped(recording: Recording) -> Iterator[Finding]:
    """Report a follower that turns by the angle at which the leader sees the follower.

    The follower should turn by the angle at which it sees the leader.
    """
    names, own = list(turtles(recording)), own_nodes(recording)
    turned = {finding.facts['turtle'] for finding in other_yaw.look(recording)} if len(names) > 1 else set()
    for turtle, rows in commands(recording).items() if len(names) > 1 else ():
        if turtle in turned:
            continue
        node = rows[0][1] if rows else ''
        turning = [(time, wire[5]) for time, who, wire in rows if who == node and wire[5]][-200:]
        if node not in own or len(turning) < SAMPLES or len({speed for _, speed in turning}) <= WRITTEN:  # no formula
            continue
        mine = _poses(recording, turtle)
        for leader in (name for name in names if name != turtle):
            theirs = _poses(recording, leader)
            right, swapped, fixed, seen = [], [], [], []
            for time, speed in turning:
                me, it = _at(mine, time), _at(theirs, time)
                if me is not None and it is not None:
                    right.append(speed / (_bearing(me, it) or 1e-9))
                    swapped.append(speed / (_bearing(it, me) or 1e-9))
                    seen.append(_bearing(ORIGIN, it))
                    fixed.append(speed / (seen[-1] or 1e-9))
            if len(swapped) < SAMPLES or _is_one_number(right):
                continue
            if _is_one_number(swapped):
                yield _swapped(recording, node, turtle, leader, None)
            elif _is_one_number(fixed) and max(seen) - min(seen) > MOVES:
                yield _swapped(recording, node, turtle, leader, leader)


def _swapped(recording: Recording, node: str, turtle: str, leader: str, fixed: str | None) -> Finding:
    process = programs(recording).get(node)
    lookup = next((one for one in recording.facts if one.kind == 'lookup failed' and one.process == process), None)
    file, line = end_place(recording, 'publisher', f'{turtle}/cmd_vel', node) if lookup is None else fact_place(recording, lookup)
    facts: dict[str, Any] = {'node': node, 'leader': leader, 'own': turtle[1:], 'other': leader[1:], 'fixed': fixed}
    return found('turtle', turtle, file=file, line=line, **facts)


def _poses(recording: Recording, turtle: str) -> tuple[list[int], list[Any]]:
    rows = recording.wires(f'{turtle}/pose', POSE)
    return [time for time, _ in rows], [wire for _, wire in rows]


def _at(poses: tuple[list[int], list[Any]], time_ns: int) -> Any:
    """Return the last pose before a time, or None.

    :param poses: the times in nanoseconds, and the poses.
    :param time_ns: the time in nanoseconds.
    """
    number = bisect_right(poses[0], time_ns) - 1
    return None if number < 0 else poses[1][number]


def _bearing(seen_from: Any, of: Any) -> float:
    """Return the direction from one turtle to another, in radians relative to the heading of the first turtle."""
    angle = math.atan2(of[1] - seen_from[1], of[0] - seen_from[0]) - seen_from[2]
    return math.atan2(math.sin(angle), math.cos(angle))


def _is_one_number(ratios: list[float]) -> bool:
    """Return whether at least 90 % of the values are close to their median."""
    ordered = sorted(ratios)
    middle = ordered[len(ordered) // 2]
    near = sum(abs(value - middle) <= CLOSE * abs(middle) for value in ratios)
    return bool(middle) and near >= 0.9 * len(ratios)


@lru_cache(maxsize=1)
def _turned(recording: Recording) -> list[tuple[Broadcasts, str, list[tuple[float, float, Any]]]]:
    """Return the moving frames at the positions of turtles, each with the name of the turtle and its transforms.

    A transform is the sine and the cosine of half the heading, and the rotation.
    """
    frames = {turtle[1:]: turtle for turtle in turtles(recording)}
    turned = []
    for one in broadcasts(recording):
        turtle = frames.get(one.child.removeprefix('/'))
        if turtle is None or one.is_static:
            continue
        poses = _poses(recording, turtle)
        rows = [
            (pose, row)
            for time, node, wire in recording.published('/tf', 'tf2_msgs/msg/TFMessage')[-2000:]
            if node == one.node
            for row in wire[0]
            if row[3] == one.child and (pose := _at(poses, time)) is not None
        ]
        if sum(math.hypot(pose[0] - row[4], pose[1] - row[5]) < AT_TURTLE_M for pose, row in rows) * 2 >= len(rows):
            turned.append((one, turtle, [(math.sin(pose[2] / 2), math.cos(pose[2] / 2), row[7:]) for pose, row in rows]))
    return turned


@rule(
    'tf.other-yaw',
    what=(
        "{node} broadcasts '{frame}' with a rotation by the heading of {in_degrees} in degrees",
        "{node} broadcasts '{frame}' with a rotation that is not the heading of {turtle}",
    ),
    why='a listener computes directions from this rotation, so a follower turns the wrong way',
    do=(
        'leave out the conversion to degrees: the theta of {in_degrees} and the angles of quaternion_from_euler() are in radians',
        'use transform.rotation.z = math.sin(message.theta / 2) and transform.rotation.w = math.cos(message.theta / 2), '
        'or compare the function that computes your quaternion with these formulas',
    ),
    lesson=LESSON,
    level='error',
    hides=('turtlesim.wall', 'tf.lookup-swapped'),
)
def other_yaw(recording: Recording) -> Iterator[Finding]:
    """Report a turtle's frame whose rotation differs from the turtle's heading by more than 0.4 rad in nine of ten transforms.

    The frame must have the position of the turtle.
    """
    for one, turtle, known in _turned(recording):
        upright = [(s, c, q) for s, c, q in known if abs(q[0]) < CLOSE and abs(q[1]) < CLOSE]
        if len(upright) < SAMPLES or len(upright) < len(known) or one.parent.removeprefix('/') != 'world':
            continue
        off = [_differ(s, c, q) for s, c, q in upright]
        halves = [(math.degrees(math.atan2(s, c)), q) for s, c, q in upright]
        in_degrees = sum(not _differ(math.sin(half), math.cos(half), q) for half, q in halves) >= 0.9 * len(off)
        turns = max(s for s, _, _ in upright) - min(s for s, _, _ in upright) > MOVES
        is_left_out = all(abs(q[2]) < CLOSE for _, _, q in upright)  # w = 1 alone sets no direction
        if (sum(off) >= 0.9 * len(off) and (turns or not is_left_out)) or (in_degrees and sum(off) >= 0.5 * len(off)):
            file, line = broadcast_place(recording, one.node, '/tf')
            facts = {'node': one.node, 'turtle': turtle, 'in_degrees': turtle if in_degrees else None}
            yield found('frame', one.child, file=file, line=line, time_s=one.first_s, **facts)


def _differ(sine: float, cosine: float, rotation: Any) -> bool:
    """Return whether a rotation differs from an angle, given by the sine and cosine of its half, by more than 0.4 rad."""
    return bool(abs(sine * rotation[2] + cosine * rotation[3]) < FAR * math.hypot(rotation[2], rotation[3]))


@rule(
    'tf.quaternion-order',
    what="{node} broadcasts '{frame}' with a rotation in the order w, x, y, z, which tilts the frame",
    why='ROS 2 uses the order x, y, z, w, but transforms3d and other libraries start with w',
    do='set rotation.x = 0.0, rotation.y = 0.0, rotation.z = sin(theta / 2) and rotation.w = cos(theta / 2)',
    lesson=LESSON,
    level='error',
    hides=('turtlesim.wall',),
)
def quaternion_order(recording: Recording) -> Iterator[Finding]:
    """Report a turtle's frame whose quaternions have the wrong order: x is the cosine of half the heading, and w is the sine.

    All of the last transforms must have this order.
    """
    for one, _, known in _turned(recording):
        if known and all(
            abs(abs(q[0]) - abs(c)) < CLOSE and abs(abs(q[3]) - abs(s)) < CLOSE and abs(q[0]) > CLOSE for s, c, q in known
        ):
            file, line = broadcast_place(recording, one.node, '/tf')
            yield found('frame', one.child, file=file, line=line, time_s=one.first_s, node=one.node)


@rule(
    'tf.other-axis',
    what="{node} turns '{frame}' about its {axis} axis by the heading of {turtle}, but a turtle turns about the z axis",
    why='the three angles are roll, pitch and yaw, and only yaw, the last one, turns a frame in the plane',
    do='write quaternion_from_euler(0, 0, theta), or set rotation.z = sin(theta / 2) and rotation.w = cos(theta / 2)',
    lesson=LESSON,
    level='error',
    hides=('turtlesim.wall', 'tf.quaternion-order'),
)
def other_axis(recording: Recording) -> Iterator[Finding]:
    """Report a turtle's frame whose quaternions contain the sine of half the heading in x or y instead of z."""
    for one, turtle, known in _turned(recording):
        for at, axis in ((0, 'x'), (1, 'y')):
            exact = [
                abs(abs(q[at]) - abs(s)) < CLOSE and abs(abs(q[3]) - abs(c)) < CLOSE and abs(q[2]) < CLOSE for s, c, q in known
            ]
            if known and all(exact) and any(abs(s) > MOVES for s, _, _ in known):
                file, line = broadcast_place(recording, one.node, '/tf')
                facts = {'node': one.node, 'turtle': turtle, 'axis': axis}
                yield found('frame', one.child, file=file, line=line, time_s=one.first_s, **facts)


@rule(
    'launch.remapping-reversed',
    what="the remapping of '{old}' to '{new}' disconnects {node} from {old}, which another node uses",
    why='the first name of a remapping is the name in the code of the node, and the second name replaces it',
    do=(
        'add the same remapping to {other}, or remove this remapping',
        "remove this remapping, or swap its names if the code of {unread} uses '{new}': remappings=[('{new}', '{old}')]",
        "swap the names: remappings=[('{new}', '{old}')]",
    ),
    lesson='02_names',
    level='error',
    hides=('messages.other-topic', 'messages.nobody-listens', 'messages.nobody-publishes', 'launch.remapping-unused'),
)
def remapping_reversed(recording: Recording) -> Iterator[Finding]:
    """Report a remapping with swapped names.

    The node's endpoint has the second name and no partner, and another node's endpoint has the first name. A subscription with
    the first name must have no partner. If the code of the node contains the first name, the order is right, and the other node
    needs the same remapping.
    """
    lone = {kind: lone_ends(recording, kind) for kind in ('publisher', 'subscription')}
    for process in recording.processes:
        node = next((node.name for node in recording.nodes if node.process == process.name), '')
        for one in remappings(process) if node else ():
            namespace, _, name = node.rpartition('/')
            old, new = (expand_name(each, name, namespace or '/') for each in (one.match, one.replacement))
            mine = [end for ends in lone.values() for end in ends if (end.name, end.node) == (new, node)]
            others = [*lone['subscription'], *ends_by_name(recording).get(('publisher', old), ())]
            for end in mine:
                partner = next(
                    (each for each in others if (each.name, each.type) == (old, end.type) and each.kind != end.kind), None
                )
                if partner is not None and partner.node != node:
                    file, line = places(recording).get(process.name, NOWHERE)
                    code = _code_of(recording, end)
                    facts: dict[str, Any] = {
                        'old': one.match,
                        'new': one.replacement,
                        'other': partner.node if _has_first_name(code, end, old) else None,
                        'unread': None if 'create_' in code else end.node,
                    }
                    yield found('node', node, file=file, line=line, **facts)


def _code_of(recording: Recording, end: EndRecord) -> str:
    """Return the lines that create an endpoint. For a program of ROS 2, they are the lines that start it in a launch file."""
    file, line = end_place(recording, end.kind, end.name, end.node)
    return ''.join(linecache.getline(file or '', (line or 0) + number) for number in range(3))  # the call may have several lines


def _has_first_name(code: str, end: EndRecord, old: str) -> bool:
    """Return whether the lines that create an endpoint contain the name that a remapping has replaced."""
    first, second = (name.rpartition('/')[2] for name in (old, end.name))
    return first != second and re.search(rf'\b{re.escape(first)}[\'"]', code) is not None


@rule(
    'programs.joined-strings',
    what="a comma is missing between '{first}' and '{second}', so Python joins them to '{joined}'",
    why='Python joins two strings that follow each other',
    do="write a comma between them: '{first}', '{second}'",
    lesson='00_python',
    level='error',
    hides=(
        'messages.other-topic',
        'messages.nobody-listens',
        'messages.nobody-publishes',
        'messages.no-server',
        'tf.unknown-frame',
        'programs.ended-at-once',
    ),
    edits=(("'{first}' '{second}'", "'{first}', '{second}'"), ('"{first}" "{second}"', '"{first}", "{second}"')),
)
def joined_strings_used(recording: Recording) -> Iterator[Finding]:
    """Report two strings on one line that Python joins, if a topic, service, node or frame of the run contains the joined
    name.
    """
    lone = [end.name for kind in ('publisher', 'subscription') for end in lone_ends(recording, kind)]
    unknown = [name for fact in recording.facts if fact.kind == 'lookup failed' for name in fact.data['unknown']]
    wanted = [fact.data['name'] for fact in recording.facts if fact.kind in ('server awaited', 'request lost')]
    names = [*lone, *unknown, *wanted]
    parts = {part for name in names for part in name.split('/')}
    if not names:
        return
    for file, _ in [*launch_scripts(recording), *program_scripts(recording)]:
        for first, second, line in joined_strings(file):
            joined = first + second
            if re.fullmatch(r'[\w/]{2,}', joined) and first and second and (joined in parts or joined in names):
                yield found('text', joined, file=file, line=line, first=first, second=second, joined=joined)


@rule(
    'tf.loop',
    what='each of the frames {frames} is the parent of the next, so they form a loop',
    why='frames must form a tree, and every lookup in a loop fails',
    do="remove one of the transforms: the top frame, such as 'map' or 'world', has no parent",
    lesson=LESSON,
    level='error',
    hides=('tf.two-parents', 'tf.separate-trees', 'tf.unknown-frame', 'tf.lookup-past', 'tf.lookup-future'),
)
def loop(recording: Recording) -> Iterator[Finding]:
    """Report each loop of frames once, at the first transform of one of its frames."""
    links = {child: found_links[0] for child, found_links in by_child(recording).items()}
    seen: set[str] = set()
    for start in links:
        ring: list[str] = []
        frame = start
        while frame in links and frame not in ring:
            ring.append(frame)
            frame = links[frame].parent.removeprefix('/')
        if frame in ring and len(ring[ring.index(frame) :]) > 1 and not seen & set(ring):
            members = ring[ring.index(frame) :]
            one = links[members[0]]
            file, line = broadcast_place(recording, one.node, '/tf_static' if one.is_static else '/tf')
            yield found(
                'frame', frame, file=file, line=line, time_s=one.first_s, frames=[*members[::-1], members[-1]], node=one.node
            )
        seen |= set(ring)
