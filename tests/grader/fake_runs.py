"""Runs of the turtle exercises made by hand: a recording that a correct solution would leave, to be spoilt by tests."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import cos, sin
from typing import Any

from fake_recording import FILE, Track, process, samples, tf_wires

from edulaunch.engine.recording.records import (
    DeclaredArgument,
    Frame,
    LaunchRecord,
    NodeRecord,
    Parameter,
    ProcessRecord,
    TopicRecord,
)

TIMES = [t / 10 for t in range(220)]
UNTURNED = (0.0, 0.0, 0.0, 1.0)


@dataclass
class FakeRun:
    """What the rubrics of the turtle exercises read of a recording."""

    launch: LaunchRecord = LaunchRecord(file=FILE)
    processes: list[ProcessRecord] = field(default_factory=list)
    advice: tuple[()] = ()
    nodes: list[NodeRecord] = field(default_factory=list)
    topics: dict[str, TopicRecord] = field(default_factory=dict)
    tracks: dict[str, Track] = field(default_factory=dict)
    values: dict[str, dict[str, Parameter]] = field(default_factory=dict)
    frames: Callable[[float], Mapping[str, Frame]] = lambda time_s: {}
    duration_s: float = 20.0
    start_ns: int = 0
    owners: dict[str, list[int]] | None = None
    hosted: dict[int, tuple[str, str]] | None = None

    def series(self, topic: str, *fields: str) -> list[Any]:
        return samples(self.tracks.get(topic, []), fields)

    def parameters(self, node: str) -> dict[str, Parameter]:
        return self.values.get(node, {})

    @property
    def parameter_rows(self) -> list[tuple[int, str, str, Any, str]]:
        names = dict.fromkeys(node.name for node in self.nodes)
        return [(0, node, name, *values) for node in names for name, values in self.parameters(node).items()]

    def frames_at(self, time_s: float) -> Mapping[str, Frame]:
        return self.frames(time_s)

    def wires(self, topic: str, type_name: str) -> list[tuple[int, Any]]:
        return tf_wires(self.frames_at, self.duration_s, topic)


def program(number: int, package: str, executable: str, **changes: Any) -> ProcessRecord:
    """A process whose launch name ends in its number."""
    return process(package, executable, parameter_origins={}, **changes)._replace(name=f'{executable}-{number}')


def node(name: str, of: ProcessRecord, publishes: str = '', listens: str = '') -> NodeRecord:
    """A node with at most one publisher and one subscription."""
    return NodeRecord(
        name, of.name, 0.0, None, [(publishes, 't')] if publishes else [], [(listens, 't')] if listens else [], [], []
    )


def mimic(of: ProcessRecord, original: str, copy: str) -> NodeRecord:
    """The node of a program mimic that copies a turtle."""
    found = node('/mimic', of, publishes=f'{copy}/cmd_vel')
    return found._replace(subscriptions=[(f'{original}/pose', 'turtlesim/msg/Pose')])


def frame(
    parent: str,
    x: float,
    y: float,
    z: float = 0.0,
    rotation: tuple[float, float, float, float] = UNTURNED,
    is_static: bool = False,
) -> Frame:
    return Frame(parent, (x, y, z), rotation, is_static, 0.0)


def declared(name: str, default: str | None) -> LaunchRecord:
    return LaunchRecord(file=FILE, declared=[DeclaredArgument(name, default, '', None, FILE, 3)])


def stays(x: float, y: float) -> Track:
    return [(t, x, y) for t in TIMES]


def circles(radius: float, turn: float, speed: float = 1.0) -> Track:
    """A circle about (5, 5); with `speed` below 1 it falls behind."""
    return [(t, 5 + radius * sin(turn * t * speed), 5 - radius * cos(turn * t * speed)) for t in TIMES]


def late(track: Track, by_s: float) -> Track:
    """The same way, some time later: what a follower drives."""
    behind = round(by_s * 10)
    return [(time, *track[max(0, index - behind)][1:]) for index, (time, _, _) in enumerate(track)]


def statuses(results: Any) -> dict[str, str]:
    """The checks that did not pass."""
    return {name: result.status for name, result in results.items() if result.status != 'passed'}
