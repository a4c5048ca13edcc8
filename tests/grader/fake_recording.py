"""Small recordings made by hand, for rubrics: only what a check asks for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import cos, hypot, sin
from typing import Any

from edugrade import Scenario
from edugrade.evidence import Outcome
from edugrade.judging import judge
from edugrade.rubrics.catalogue import find_rubric
from edugrade.source import SubmittedText, shipped_program

from edulaunch.engine.recording.records import DeclaredArgument, Frame, LaunchRecord, NodeRecord, Parameter, ProcessRecord

FILE = '/student/a.launch.py'
TEXT = 'def generate_launch_description():\n    return LaunchDescription([\n    ])\n'
Track = list[tuple[float, float, float]]


@dataclass
class FakeRecording:
    """What the rubrics read of a recording."""

    launch: LaunchRecord = LaunchRecord(file=FILE)
    processes: list[ProcessRecord] = field(default_factory=list)
    advice: tuple[()] = ()
    nodes: list[NodeRecord] = field(default_factory=list)
    tracks: dict[str, Track] = field(default_factory=dict)
    radius: Any = None
    frames: dict[str, Frame] = field(default_factory=dict)
    duration_s: float = 20.0
    start_ns: int = 0
    owners: dict[str, list[int]] | None = None
    hosted: dict[int, tuple[str, str]] | None = None

    @property
    def includes(self) -> list[str]:
        return self.launch.includes

    @property
    def topics(self) -> dict[str, Any]:
        return dict.fromkeys(self.tracks)

    def series(self, topic: str, *fields: str) -> list[Any]:
        return samples(self.tracks.get(topic, []), fields)

    def parameters(self, node: str) -> dict[str, Parameter]:
        return {} if self.radius is None else {'radius': Parameter(self.radius, 'launch argument')}

    @property
    def parameter_rows(self) -> list[tuple[int, str, str, Any, str]]:
        names = dict.fromkeys(node.name for node in self.nodes)
        return [(0, node, name, *values) for node in names for name, values in self.parameters(node).items()]

    def frames_at(self, time_s: float) -> dict[str, Frame]:
        return self.frames

    def wires(self, topic: str, type_name: str) -> list[tuple[int, Any]]:
        return tf_wires(self.frames_at, self.duration_s, topic)


def samples(track: Track, fields: tuple[str, ...]) -> list[Any]:
    """The track as a list, with the speed that explains each step when somebody asks for it."""
    if 'linear_velocity' not in fields:
        return list(track)
    steps = zip(track, [track[0], *track] if track else [], strict=False)
    return [(*b, hypot(b[1] - a[1], b[2] - a[2]) / ((b[0] - a[0]) or 1.0)) for b, a in steps]


def tf_wires(frames_at: Callable[[float], Mapping[str, Frame]], duration_s: float, topic: str) -> list[tuple[int, Any]]:
    """What was published on /tf every half second, and on /tf_static whenever it changed, so that these frames were there."""
    found: list[tuple[int, Any]] = []
    before: list[Any] = []
    for time_s in [step / 2 for step in range(int(duration_s * 2) + 1)]:
        known = [(name, frame) for name, frame in frames_at(time_s).items() if frame.is_static == (topic == '/tf_static')]
        rows = [(0, 0, frame.parent, name, *frame.translation, *frame.rotation) for name, frame in known]
        if rows and not (topic == '/tf_static' and rows == before):
            found.append((int(time_s * 10**9), (rows,)))
        before = rows
    return found


def process(package: str, executable: str, **changes: Any) -> ProcessRecord:
    return ProcessRecord(
        f'{executable}-1', 1002, [shipped_program(package, executable)], package, executable, FILE, 7, {'radius': 'here'}, 0.0
    )._replace(**changes)


def arc(radius: float, duration_s: float = 20.0, speed: float = 0.1) -> Track:
    """Where a robot is that drives a circle at `speed` metres per second, ten times a second."""
    times = [step / 10 for step in range(int(duration_s * 10))]
    return [(t, radius * sin(speed * t / radius), radius * (1 - cos(speed * t / radius))) for t in times]


def circle_run(radius: float, **changes: Any) -> FakeRecording:
    """A run of a correct circle.launch.py."""
    argument = DeclaredArgument('circle_radius', '1.0', 'a radius', None, FILE, 3)
    return FakeRecording(
        **{
            'launch': LaunchRecord(file=FILE, declared=[argument]),
            'processes': [process('part3_beyond_basics', 'param_circle.py')],
            'nodes': [NodeRecord('/circle', 'param_circle.py-1', 0.0, None, [], [], [], [])],
            'tracks': {'/odom': arc(radius)},
            'radius': radius,
            **changes,
        }
    )


def graded(exercise: str, run: Callable[[Scenario], Any], seed: int = 0, wrote: str = '') -> Mapping[str, Any]:
    """The results of a rubric over made-up runs, by name of the check; `wrote` stands in the student's file."""
    rubric = find_rubric(exercise)[1]
    outcomes = [Outcome(scenario, 'recorded', run(scenario)) for scenario in rubric.scenarios(seed)]
    return {result.name: result for result in judge(rubric.checks, outcomes, SubmittedText(FILE, f'{TEXT}{wrote}\n'))}
