"""A timeline is the same run in one delta or in many, and nothing in it is more than plain data."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest

import edulaunch
from edulaunch.advice.rendering import Mark
from edulaunch.desk.view.columns import FINE
from edulaunch.desk.view.page import packed
from edulaunch.desk.view.replay import RecorderSource, RecordingSource, timeline_of
from edulaunch.desk.view.timeline import SCAN_TYPE, Timeline
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.recording import Recording
from edulaunch.runtime.session import Session
from tests.desk.view.conftest import numbers


@pytest.fixture(scope='module')
def recording() -> Recording:
    return edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=3, seed=0)


def test_what_the_rules_say_is_told_once_as_plain_data(recording: Recording) -> None:
    timeline = Timeline(RecordingSource(recording))
    timeline.mark([Mark(1.5, ('topic', '/tf'), 'nobody listens', 'lonely-topic'), Mark(0, ('', ''), 'all is well', 'fine')])
    assert timeline.delta()['advice'] == [
        {'time': 1_500_000, 'subject': {'topic': '/tf'}, 'text': 'nobody listens', 'rule': 'lonely-topic'},
        {'time': 0, 'subject': {}, 'text': 'all is well', 'rule': 'fine'},
    ]
    assert 'advice' not in timeline.delta()


def test_rules_that_are_attached_are_asked(recording: Recording, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('edulaunch.advice.rendering.marks', every_frame)
    assert [row['subject'] for row in timeline_of(recording)['advice']] == [{'frame': 'turtle1'}, {'frame': 'turtle2'}]


def every_frame(recording: Recording) -> list[Mark]:
    return [Mark(0.0, ('frame', name), 'a frame', 'frames') for name in recording.frames_at(3)]


def whole(recording: Recording) -> dict[str, Any]:
    return Timeline(RecordingSource(recording)).delta()


def topic(delta: dict[str, Any], name: str) -> dict[str, Any]:
    found: dict[str, Any] = next(row for row in delta['topics'] if row['name'] == name)
    return found


def joined(deltas: list[dict[str, Any]], name: str, field: str) -> tuple[list[float], list[float]]:
    """Times in seconds and values of a field over all deltas."""
    times: list[float] = []
    values: list[float] = []
    for delta in deltas:
        for row in delta['topics']:
            if row['name'] == name:
                place = [path for path, _ in row['fields']].index(field)
                times += numbers(row['t'], 1, round(times[-1]) if times else 0)
                values += numbers(row['c'][place], FINE, round(values[-1] * FINE) if values else 0)
    return [time / 1e6 for time in times], values


def test_the_poses_are_those_of_the_recording(recording: Recording) -> None:
    times, values = joined([whole(recording)], '/turtle2/pose', 'x')
    rows = recording.series('/turtle2/pose', 'x')
    assert times == [pytest.approx(time, abs=1e-6) for time, _ in rows]
    assert values == [pytest.approx(x, abs=1e-4) for _, x in rows]


def test_deltas_of_a_living_machine_join_to_the_whole() -> None:
    with Session() as session:
        session.launch('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
        timeline, deltas = Timeline(RecorderSource(session.recorder)), []
        for _ in range(6):
            session.run(0.5)
            deltas.append(timeline.delta())
        rows = session.recording().series('/turtle2/pose', 'y')
    times, values = joined(deltas, '/turtle2/pose', 'y')
    assert times == [pytest.approx(time, abs=1e-6) for time, _ in rows]
    assert values == [pytest.approx(y, abs=1e-4) for _, y in rows]
    assert [row[1] for delta in deltas for row in delta.get('nodes', ())] == [
        '/sim',
        '/broadcaster1',
        '/broadcaster2',
        '/listener',
    ]


def test_an_ended_node_is_told_again_once() -> None:
    with Session() as session:
        session.launch('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
        timeline = Timeline(RecorderSource(session.recorder))
        session.run(1)
        assert [row[5] for row in timeline.delta()['nodes']] == [None] * 4
        session.interrupt()
        session.run(3)
        assert sorted(row[1] for row in timeline.delta()['nodes']) == ['/broadcaster1', '/broadcaster2', '/listener', '/sim']
        assert 'nodes' not in timeline.delta()


def test_transforms_have_a_track_for_each_child_and_its_publisher(recording: Recording) -> None:
    tracks = {(track['child'], track['parent'], track['static']) for track in whole(recording)['tf']}
    assert tracks == {('turtle1', 'world', False), ('turtle2', 'world', False)}


class Scanner:
    """A source with one laser that turns ten times a second."""

    def topics(self) -> list[tuple[str, str]]:
        return [('/scan', SCAN_TYPE)]

    def rows(self, topic: str, kind: str, first: int) -> tuple[list[int], list[int], list[Any]]:
        wire = (0, 0, 'laser', -1.0, 1.0, 0.5, 0.0, 0.1, 0.12, 3.5, (0.1, 0.2, math.inf, math.nan, 3.4), ())
        return [number * 100_000_000 for number in range(5)][first:], [1] * (5 - first), [wire] * (5 - first)

    def part(self, name: str) -> list[Any]:
        return []

    def numbers(self, name: str) -> list[int]:
        return []

    def forgotten(self, topic: tuple[str, str]) -> int:
        return 0

    def lines(self) -> dict[int, tuple[str, int]]:
        return {}

    def beside(self, name: str, since: object) -> list[Any]:
        return []

    def wire_type(self, kind: str) -> list[tuple[str, str]]:
        names = ['angle_min', 'angle_max', 'angle_increment', 'time_increment', 'scan_time', 'range_min', 'range_max']
        stamp = [('header.stamp.sec', 'int32'), ('header.stamp.nanosec', 'uint32'), ('header.frame_id', 'string')]
        return [*stamp, *((name, 'float32') for name in names), ('ranges', 'float32[]'), ('intensities', 'float32[]')]

    def start_ns(self) -> int:
        return 0

    def now_ns(self) -> int:
        return 400_000_000


def test_scans_are_thinned_and_have_no_number_that_is_no_range() -> None:
    scans = Timeline(Scanner()).delta()['scans']
    assert [scan[1] for scan in scans] == [0, 200_000, 400_000]
    assert scans[0][2:] == ['laser', -1.0, 0.5, [None, 20, None, None, 340]]


def test_a_film_is_json_small_and_the_same_for_the_same_run(recording: Recording) -> None:
    delta = whole(recording)
    assert json.loads(json.dumps(delta, allow_nan=False)) == delta
    again = edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=3, seed=0)
    assert packed(whole(again)) == packed(delta)
    assert len(packed(delta)) < 20_000


def test_a_film_goes_on_when_a_machine_has_forgotten_its_past() -> None:
    with Session() as session:
        session.launch('turtle_tf2_py', 'turtle_tf2_demo.launch.py')
        timeline, deltas = Timeline(RecorderSource(session.recorder)), []
        for _ in range(6):
            session.run(0.5)
            deltas.append(timeline.delta())
            session.recorder.forget_before(session.sim.now_ns - 200_000_000, 3)
        rows = Timeline(RecorderSource(session.recorder)).delta()
    times, values = joined(deltas, '/turtle1/pose', 'x')
    assert len(times) == 186 and times == sorted(set(times))
    assert len(numbers(topic(rows, '/turtle1/pose')['t'], 1)) < 20
    assert len(values) == len(times)
    assert [row[7] for delta in deltas for row in delta.get('calls', ())] == [None, 1_008_000]


def test_rows_that_a_machine_has_forgotten_in_between_are_told_once_and_keep_their_numbers() -> None:
    """A page knows nodes and processes by their numbers."""
    with Session() as session:
        timeline, deltas = Timeline(RecorderSource(session.recorder)), []
        for name in ('guest', 'stays', 'other'):
            words = ('ros2', 'run', 'demo_nodes_py', 'listener', '--ros-args', '-r', f'__node:={name}')
            process = session.host.start(ProcessSpec(argv=words, name=name))
            session.run(1)
            if name == 'guest':
                process.send_signal(2)
            session.run(5)
            deltas.append(timeline.delta())
            session.recorder.forget_before(session.sim.now_ns - 10**9, 3)
        process.send_signal(2)
        session.run(1)
        deltas.append(timeline.delta())
    told = [[(row[0], row[1], row[4]) for row in delta.get('nodes', ())] for delta in deltas]
    assert [[row[:2] for row in rows] for rows in told] == [[(0, '/guest')], [(1, '/stays')], [(2, '/other')], [(2, '/other')]]
    assert [row[2] for delta in deltas for row in delta.get('endpoints', ())].count('/chatter') == 3
