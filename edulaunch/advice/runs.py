"""Queries about a run that several rules need: places in the student's files, nodes and endpoints, and broadcast transforms."""

from __future__ import annotations

import ast
import math
import os
import re
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from edulaunch.engine.recording.records import PARAMETER_SERVICES

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import EndRecord, Fact

Place = tuple[str | None, int | None]
NOWHERE: Place = (None, None)
_ORIGIN = re.compile(r'(.+) line (\d+)')
INTERRUPTS = ('KeyboardInterrupt', 'ExternalShutdownException')
"""The exceptions with which Ctrl-C ends a program. They are not mistakes of the program."""
ROS_OWN = ('/parameter_events', '/rosout', '/clock', '/tf', '/tf_static')
"""Topics that every node has, or that have their own rules."""


@lru_cache(maxsize=1)
def places(recording: Recording) -> dict[str, Place]:
    """Return the launch file and line that started each program, by the program's launch name."""
    return {process.name: process.origin or NOWHERE for process in recording.processes}


@lru_cache(maxsize=1)
def programs(recording: Recording) -> dict[str, str]:
    """Return the launch name of each node's program, by the name of the node."""
    return {node.name: node.process for node in recording.nodes}


def node_of(recording: Recording, process: str | None) -> str:
    """Return the name of a program's first node, or its launch name if it has no node."""
    return next((node.name for node in recording.nodes if node.process == process), process or '')


def speaker(recording: Recording, node: str) -> str:
    """Return the name of a node for users. For the node of a `ros2` command, return the name of the command."""
    return programs(recording).get(node, node) if node.startswith('/_ros2cli') else node


def node_place(recording: Recording, node: str) -> Place:
    """Return the place at which the program of a node was started."""
    return places(recording).get(programs(recording).get(node, ''), NOWHERE)


@lru_cache(maxsize=1)
def _end_places(recording: Recording) -> dict[tuple[str, str, str], Place]:
    """Return the place at which each endpoint was first created, by (kind, name, node)."""
    nodes = {row[4]: row[0] for row in recording.rows('nodes')}
    return {
        (kind, name, nodes.get(node, '')): recording.lines[index]
        for kind, name, _, node, index, *_ in reversed(recording.rows('endpoints'))
        if index in recording.lines
    }


def end_place(recording: Recording, kind: str, name: str, node: str) -> Place:
    """Return the student's line that created an endpoint. If it is unknown, return the place at which its program was started."""
    return _end_places(recording).get((kind, name, node)) or node_place(recording, node)


def files_of(recording: Recording, node: str) -> set[str]:
    """Return the student's files that created the endpoints of a node."""
    return {place[0] for (_, _, owner), place in _end_places(recording).items() if owner == node and place[0] is not None}


def broadcast_place(recording: Recording, node: str, topic: str) -> Place:
    """Return the student's line that sends transforms. If a file has several such lines, return the line of the broadcaster."""
    file, line = end_place(recording, 'publisher', topic, node)
    calls = () if file is None else _calls_of('sendTransform', file)
    return (file, calls[0]) if len(calls) == 1 else (file, line)


@lru_cache(maxsize=16)
def _calls_of(method: str, file: str) -> tuple[int, ...]:
    """Return the lines of a Python file that call a method with this name."""
    from edulaunch.ros.sources.source_package import parsed

    tree = parsed(file) if file.endswith('.py') else None
    return (
        ()
        if tree is None
        else tuple(
            node.lineno
            for node in ast.walk(tree)
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == method
        )
    )


def fact_place(recording: Recording, fact: Fact) -> Place:
    """Return the student's line that a fact names, or the place at which its program was started."""
    if 'file' in fact.data:
        return fact.data['file'], fact.data['line']
    return places(recording).get(fact.process or '', NOWHERE)


def asking_place(recording: Recording, node: str, name: str) -> Place:
    """Return the line where a node calls a missing service or action, or waits for it.

    Without such a line, return the place at which the program was started.
    """
    for fact in recording.facts:
        if fact.kind in ('request lost', 'server awaited') and (fact.data['node'], fact.data['name']) == (node, name):
            return fact_place(recording, fact)
    return node_place(recording, node)


def origin_place(recording: Recording, process: str | None, origin: str) -> Place:
    """Return the place that the origin of a parameter names, such as 'a.launch.py line 4'.

    For any other origin, return the place at which the program was started.
    """
    started = places(recording).get(process or '', NOWHERE)
    match = _ORIGIN.fullmatch(origin)
    if match is None:
        return started
    if started[0] is not None and os.path.basename(started[0]) == match[1]:
        return started[0], int(match[2])
    return passed_file(recording, match[1]), int(match[2])


def passed_file(recording: Recording, name: str) -> str:
    """Return the student's path of a file that a command line names. If no command line contains its path, return the name."""
    words = (word for process in recording.processes for word in process.argv)
    return next((os.path.realpath(word) for word in words if os.path.basename(word) == name and os.path.isabs(word)), name)


@lru_cache(maxsize=1)
def own_nodes(recording: Recording) -> set[str]:
    """Return the names of the nodes whose programs were written by a student."""
    own = {process.name for process in recording.own_processes}
    return {node.name for node in recording.nodes if node.process in own}


@lru_cache(maxsize=1)
def ends_by_name(recording: Recording) -> dict[tuple[str, str], list[EndRecord]]:
    """Return all endpoints by (kind, absolute name), in the order of their creation."""
    found: dict[tuple[str, str], list[EndRecord]] = {}
    for end in recording.ends:
        found.setdefault((end.kind, end.name), []).append(end)
    return found


def names_of(recording: Recording, kind: str) -> list[str]:
    """Return the absolute names of all endpoints of a kind. Leave out the endpoints that ROS 2 creates for every node."""
    nodes = tuple(f'{node.name}/' for node in recording.nodes)
    return [name for end_kind, name in ends_by_name(recording) if end_kind == kind and not is_ros_own(name, nodes)]


def is_ros_own(name: str, nodes: tuple[str, ...] = ()) -> bool:
    """Return whether ROS 2 itself creates a topic or service with this name.

    :param name: the absolute name.
    :param nodes: the full names of nodes, each with a slash at its end. Their parameter services belong to ROS 2.
    """
    return name in ROS_OWN or '/_' in name or (name.startswith(nodes) and name.rpartition('/')[2] in PARAMETER_SERVICES)


TF_TYPE = 'tf2_msgs/msg/TFMessage'
TINY = 1e-9
UNIT = 0.01
"""tf2 rejects rotations whose squared length differs more from 1."""
CLOCK_NS = 3_000_000_000
"""The largest plausible difference between a stamp and the time of the broadcast."""


class Broadcasts:
    """All transforms that one node broadcast for one frame and one parent.

    :ivar poses: the different values of static transforms, in order.
    :ivar length: the length of the first rotation whose length is not 1.
    :ivar odd: (time of the first transform in seconds, count) for each kind of invalid transform: 'zero', 'long', 'nan',
        'unstamped', 'clock'.
    :ivar stamps: the time stamps of the transforms that are counted as 'clock', in nanoseconds.
    :ivar lag_s: the age in seconds that the first transform had when it was broadcast. A negative age means a future time stamp.
    """

    def __init__(self, node: str, parent: str, child: str, is_static: bool, time_ns: int) -> None:
        self.node, self.parent, self.child, self.is_static = node, parent, child, is_static
        self.first_ns = self.last_ns = time_ns
        self.count = 0
        self.poses: list[tuple[float, ...]] = []
        self.odd: dict[str, tuple[float, int]] = {}
        self.lag_s = 0.0
        self.length = 0.0
        self.stamps: set[int] = set()

    @property
    def first_s(self) -> float:
        """The time of the first transform in seconds."""
        return self.first_ns / 1e9

    def _note(self, what: str) -> None:
        time_s, count = self.odd.get(what, (self.last_ns / 1e9, 0))
        self.odd[what] = (time_s, count + 1)

    def look(self, start_ns: int, sec: int, nanosec: int, pose: tuple[float, ...]) -> None:
        """Count one transform, and check it for mistakes.

        :param start_ns: the time at which the simulation started, in nanoseconds since the epoch.
        :param sec: the seconds of the transform's time stamp.
        :param nanosec: the nanoseconds of the transform's time stamp.
        :param pose: x, y, z in metres, and the quaternion x, y, z, w.
        """
        x, y, z, qx, qy, qz, qw = pose
        square = qx * qx + qy * qy + qz * qz + qw * qw
        check = square + x + y + z
        if check != check:
            self._note('nan')
        elif square < TINY:
            self._note('zero')
        elif abs(square - 1) > UNIT:
            self._note('long')
            self.length = self.length or math.sqrt(square)
        if self.is_static:
            if pose not in self.poses:
                self.poses.append(pose)
            return
        stamp_ns = sec * 10**9 + nanosec
        if not stamp_ns:
            self._note('unstamped')
        elif not -CLOCK_NS < (lag_ns := start_ns + self.last_ns - stamp_ns) < CLOCK_NS:
            self._note('clock')
            self.stamps.add(stamp_ns)
            self.lag_s = self.lag_s or lag_ns / 1e9


@lru_cache(maxsize=1)
def broadcasts(recording: Recording) -> list[Broadcasts]:
    """Return all broadcasts in the order of their first transforms. Static broadcasts come first."""
    found: dict[Any, Broadcasts] = {}
    for topic, is_static in (('/tf_static', True), ('/tf', False)):
        for time_ns, node, wire in recording.published(topic, TF_TYPE):
            for sec, nanosec, parent, child, *pose in wire[0]:
                key = (node, parent, child, is_static)
                known = found.get(key)
                if known is None:
                    known = found[key] = Broadcasts(node, parent, child, is_static, time_ns)
                known.last_ns = time_ns
                known.count += 1
                known.look(recording.start_ns, sec, nanosec, tuple(pose))
    return list(found.values())


@lru_cache(maxsize=1)
def by_child(recording: Recording) -> dict[str, list[Broadcasts]]:
    """Return the broadcasts by the name of the frame. The names have no leading slash, as in tf2."""
    found: dict[str, list[Broadcasts]] = {}
    for one in broadcasts(recording):
        found.setdefault(one.child.removeprefix('/'), []).append(one)
    return found


@lru_cache(maxsize=1)
def frame_names(recording: Recording) -> list[str]:
    """Return the names of all frames that were broadcast at any time, including parents."""
    return list(dict.fromkeys(name.removeprefix('/') for one in broadcasts(recording) for name in (one.parent, one.child)))


def root_of(recording: Recording, frame: str) -> str:
    """Return the name of the root of the tree that contains a frame."""
    links = by_child(recording)
    seen = [frame]
    while frame in links and (frame := links[frame][0].parent.removeprefix('/')) not in seen:
        seen.append(frame)
    return frame
