"""Each fault of broken_follow breaks its own check, and is pointed at."""

from __future__ import annotations

from typing import Any

import pytest
from edugrade import Scenario
from fake_recording import FILE, graded
from fake_runs import FakeRun, circles, frame, late, mimic, node, program, statuses, stays

from edulaunch.engine.recording.records import Parameter, TopicRecord

MIMIC = program(1, 'turtlesim', 'mimic', line=11)
POSES = {
    name: TopicRecord(name, 't', ['/sim'], ['/mimic'], 1)
    for name in ('/teacher/turtle1/pose', '/double/turtle1/pose', '/between/pose', '/between/cmd_vel')
}
COPIES = mimic(MIMIC, '/teacher/turtle1', '/turtle1')
BROADCASTER = program(2, 'turtle_tf2_py', 'turtle_tf2_broadcaster', line=22)
LISTENER = program(3, 'turtle_tf2_py', 'turtle_tf2_listener', line=33)


def run(scenario: Scenario, **changes: Any) -> FakeRun:
    radius = float(scenario.arguments['speed']) / 0.5
    track = circles(radius, 0.5)
    return FakeRun(
        **{
            'processes': [MIMIC, BROADCASTER, LISTENER],
            'nodes': [node('/listener', LISTENER), COPIES],
            'tracks': {'/teacher/turtle1/pose': track, '/turtle1/pose': track, '/turtle2/pose': late(track, 1.0)},
            'frames': lambda time_s: {'turtle1': frame('world', 5.0, 5.0), 'turtle2': frame('world', 5.0, 5.0)},
            'values': {'/listener': {'target_frame': Parameter('turtle1', 'x')}},
            'topics': {'/turtle1/cmd_vel': TopicRecord('/turtle1/cmd_vel', 't', ['/mimic'], ['/sim'], 1), **POSES},
            **changes,
        }
    )


def topic(name: str, publishers: list[str], subscriptions: list[str]) -> TopicRecord:
    return TopicRecord(name, 't', publishers, subscriptions, 0)


def test_a_correct_launch_passes_everything() -> None:
    results = graded('broken_follow', run)
    assert statuses(results) == {}
    assert sum(result.earned for result in results.values()) == 12


def test_a_mimic_whom_nobody_hears_is_pointed_at() -> None:
    def deaf(scenario: Scenario) -> FakeRun:
        good = run(scenario)
        return run(
            scenario,
            tracks={**good.tracks, '/turtle1/pose': stays(5.5, 5.5)},
            nodes=[*good.nodes[:1], node('/mimic', MIMIC, publishes='/output/cmd_vel')],
            topics={'/output/cmd_vel': topic('/output/cmd_vel', ['/mimic'], [])},
        )

    results = graded('broken_follow', deaf)
    assert statuses(results) == {'turtle1_copies': 'failed', 'turtle2_follows': 'not_run'}
    assert results['turtle1_copies'].seen.endswith('/mimic publishes on /output/cmd_vel, which has no subscriber')
    assert results['turtle1_copies'].where == (FILE, 11)


def test_a_mimic_of_another_turtle_that_drives_as_far_does_not_copy() -> None:
    other = mimic(MIMIC, '/double/turtle1', '/turtle1')
    results = graded('broken_follow', lambda s: run(s, nodes=[node('/listener', LISTENER), other]))
    assert statuses(results) == {'turtle1_copies': 'failed', 'turtle2_follows': 'not_run'}
    assert results['turtle1_copies'].seen == 'mimic subscribes to /double/turtle1/pose'


def test_a_chain_of_mimics_copies() -> None:
    first, second = mimic(MIMIC, '/teacher/turtle1', '/between'), mimic(MIMIC, '/between', '/turtle1')
    assert statuses(graded('broken_follow', lambda s: run(s, nodes=[node('/listener', LISTENER), second, first]))) == {}


def test_a_frame_of_a_turtle_that_does_not_exist_earns_nothing() -> None:
    def without(scenario: Scenario) -> FakeRun:
        tracks = {name: track for name, track in run(scenario).tracks.items() if name != '/turtle2/pose'}
        return run(scenario, tracks=tracks)

    results = graded('broken_follow', without)
    assert (results['turtle2_is_on_tf'].status, results['turtle2_is_on_tf'].reason) == ('failed', 'the turtle turtle2 is missing')


def test_a_broadcaster_that_hears_nobody_is_pointed_at() -> None:
    def silent(scenario: Scenario) -> FakeRun:
        return run(
            scenario,
            frames=lambda time_s: {'turtle1': frame('world', 5.0, 5.0)},
            nodes=[node('/listener', LISTENER), node('/b2', BROADCASTER, listens='/turtle_2/pose')],
            topics={'/turtle_2/pose': topic('/turtle_2/pose', [], ['/b2'])},
        )

    result = graded('broken_follow', silent)['turtle2_is_on_tf']
    assert result.seen == 'turtle1 (parent world)\n/b2 subscribes to /turtle_2/pose, which has no publisher'
    assert result.where == (FILE, 22)
    assert 'did you mean' not in result.try_


def test_a_misspelt_target_is_shown_with_its_origin() -> None:
    values = {'/listener': {'target_frame': Parameter('trutle1', 'a.launch.py line 33')}}
    results = graded('broken_follow', lambda s: run(s, values=values))
    assert statuses(results) == {'target_is_turtle1': 'failed', 'turtle2_follows': 'not_run'}
    assert (results['target_is_turtle1'].seen, results['target_is_turtle1'].where) == (
        'trutle1, from a.launch.py line 33',
        (FILE, 33),
    )


def test_a_teacher_that_was_changed_is_no_test_of_copying() -> None:
    def changed(scenario: Scenario) -> FakeRun:
        return run(scenario, tracks=dict.fromkeys(run(scenario).tracks, circles(0.3, 0.5)))

    results = graded('broken_follow', changed)
    assert results['teacher_drives'].seen == 'a circle with a radius of 0.30 m'
    assert results['turtle1_copies'].status == 'not_run'


def test_a_follower_that_stays_behind_is_measured() -> None:
    def lazy(scenario: Scenario) -> FakeRun:
        return run(scenario, tracks={**run(scenario).tracks, '/turtle2/pose': stays(12.0, 5.0)})

    assert statuses(graded('broken_follow', lazy)) == {'turtle2_follows': 'failed'}


@pytest.mark.parametrize('place', [(5.0, 5.0), (5.2, 4.9)])
def test_a_turtle_that_stands_in_the_middle_of_the_circle_does_not_follow(place: tuple[float, float]) -> None:
    results = graded('broken_follow', lambda s: run(s, tracks={**run(s).tracks, '/turtle2/pose': stays(*place)}))
    assert statuses(results) == {'turtle2_follows': 'failed'}
    assert results['turtle2_follows'].reason.startswith('turtle2 does not follow turtle1')


def test_a_turtle_that_dies_early_does_not_follow_to_the_end() -> None:
    def short(scenario: Scenario) -> FakeRun:
        tracks = run(scenario).tracks
        return run(scenario, tracks={**tracks, '/turtle2/pose': [s for s in tracks['/turtle2/pose'] if s[0] < 15.0]})

    assert statuses(graded('broken_follow', short)) == {'turtle2_follows': 'failed'}
