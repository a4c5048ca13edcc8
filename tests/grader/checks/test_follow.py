"""What the follower's rubric says of small made-up runs."""

from __future__ import annotations

from math import cos, sin
from typing import Any

import pytest
from edugrade import Scenario
from fake_recording import FakeRecording, Track, graded, process

from edulaunch.engine.recording.records import Frame, NodeRecord

FRAME = Frame('world', (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), False, 20.0)
TIMES = [t / 10 for t in range(200)]


class FollowRun(FakeRecording):
    """A run in which the frames of turtles are where the turtles are."""

    def frames_at(self, time_s: float) -> dict[str, Frame]:
        found = dict(self.frames)
        for name, frame in self.frames.items():
            places = [place for place in self.tracks.get(f'/{name}/pose', []) if place[0] <= time_s]
            if places:
                found[name] = frame._replace(translation=(*places[-1][1:], 0.0))
        return found


def leader(scenario: Scenario) -> Track:
    speed = 0.5 if scenario.arguments else 0.0
    return [(t, speed * t, 5.5) for t in TIMES]


def run(scenario: Scenario, lag_m: float = 0.1, **changes: Any) -> FakeRecording:
    first = leader(scenario)
    second = [(t, x - max(lag_m, 4.0 - t), y) for t, x, y in first if t > 2]
    return FollowRun(
        **{
            'processes': [process('turtlesim', 'turtlesim_node')],
            'frames': {'turtle1': FRAME, 'turtle2': FRAME},
            'tracks': {'/turtle1/pose': first, '/turtle2/pose': second},
            **changes,
        }
    )


def statuses(results: Any) -> dict[str, str]:
    return {name: result.status for name, result in results.items() if result.status != 'passed'}


def test_a_close_follower_passes_everything() -> None:
    results = graded('follow', run)
    assert statuses(results) == {}
    assert sum(result.earned for result in results.values()) == 12


def test_a_follower_that_stays_behind_fails_where_it_does() -> None:
    assert statuses(graded('follow', lambda scenario: run(scenario, lag_m=1.0))) == {'standing_leader_is_reached': 'failed'}
    results = graded('follow', lambda scenario: run(scenario, lag_m=3.0))
    assert statuses(results) == {'standing_leader_is_reached': 'failed', 'moving_leader_is_followed': 'not_run'}
    assert results['standing_leader_is_reached'].expected == 'at most 0.25 m away after 15 s'


def test_without_turtle2_its_frame_is_not_judged() -> None:
    results = graded('follow', lambda scenario: run(scenario, tracks={'/turtle1/pose': leader(scenario)}))
    assert results['follower_exists'].seen == 'only turtle1'
    assert results['moving_leader_is_followed'].root_cause == 'follower_exists'


def test_a_missing_frame_names_those_that_are_there() -> None:
    results = graded('follow', lambda scenario: run(scenario, frames={'turtle1': FRAME, 'turtel2': FRAME}))
    assert results['follower_is_on_tf'].reason == 'the frame turtle2 is missing'
    assert results['follower_is_on_tf'].seen == 'turtle1 (parent world), turtel2 (parent world)'


def test_a_frame_in_the_wrong_parent_is_no_frame_in_world() -> None:
    frames = {'turtle1': FRAME, 'turtle2': FRAME._replace(parent='turtle1')}
    results = graded('follow', lambda scenario: run(scenario, frames=frames))
    assert (results['follower_is_on_tf'].expected, results['follower_is_on_tf'].seen) == (
        'the parent world',
        'the parent turtle1',
    )


def test_a_leader_that_ignores_move_is_no_test_of_following() -> None:
    still = [(t, 5.5, 5.5) for t in TIMES]
    comes = [(t, min(5.5, 4.0 + t), 5.5) for t in TIMES]
    results = graded('follow', lambda scenario: run(scenario, tracks={'/turtle1/pose': still, '/turtle2/pose': comes}))
    assert statuses(results) == {'leader_moves_when_asked': 'failed', 'moving_leader_is_followed': 'not_run'}


def test_a_turtlesim_in_a_namespace_is_missed() -> None:
    results = graded('follow', lambda scenario: run(scenario, tracks={'/a/turtle1/pose': leader(scenario)}))
    assert results['leader_exists'].reason == 'the turtle with the topic /turtle1/pose is missing'


def test_two_broadcasters_of_one_name_are_refused() -> None:
    nodes = [NodeRecord('/broadcaster1', f'turtle_tf2_broadcaster-{number}', 0.0, None, [], [], [], []) for number in (2, 3)]
    results = graded('follow', lambda scenario: run(scenario, nodes=nodes))
    assert results['follower_is_on_tf'].status == 'failed'
    assert results['follower_is_on_tf'].seen == 'turtle_tf2_broadcaster-2 and turtle_tf2_broadcaster-3 have the same name'


def test_a_turtle_in_the_middle_of_the_square_does_not_follow() -> None:
    def middle(scenario: Scenario) -> FakeRecording:
        if not scenario.arguments:
            return run(scenario)
        first = [(t, 5.5 + cos(t), 5.5 + sin(t)) for t in TIMES]
        return run(scenario, tracks={'/turtle1/pose': first, '/turtle2/pose': [(t, 5.5, 5.5) for t in TIMES]})

    results = graded('follow', middle)
    assert statuses(results) == {'moving_leader_is_followed': 'failed'}
    assert results['moving_leader_is_followed'].seen == 'a movement of 0.00 m towards turtle1'


def test_a_turtle_that_was_spawned_at_its_goal_does_not_come_to_it() -> None:
    still = [(t, 0.1, 5.5) for t in TIMES]
    results = graded('follow', lambda scenario: run(scenario, tracks={'/turtle1/pose': leader(scenario), '/turtle2/pose': still}))
    assert results['standing_leader_is_reached'].reason == 'turtle2 does not drive to its goal in the run with no arguments'


def test_a_frame_that_is_elsewhere_than_its_turtle_is_false() -> None:
    def false(scenario: Scenario) -> FakeRecording:
        return run(scenario, frames={'turtle1': FRAME, 'turtle2': FRAME, 'turtle3': FRAME})

    def frozen(scenario: Scenario) -> FakeRecording:
        return FakeRecording(**vars(run(scenario)))

    assert graded('follow', false)['leader_is_on_tf'].status == 'passed'
    result = graded('follow', frozen)['leader_is_on_tf']
    assert (result.status, result.reason) == ('failed', 'the frame turtle1 is not where turtle1 is in the run with no arguments')


@pytest.mark.parametrize('track', ['/turtle1/pose', '/turtle2/pose'])
def test_poses_that_are_not_numbers_follow_nobody(track: str) -> None:
    nowhere = [(t, float('nan'), float('nan')) for t in TIMES]
    results = graded('follow', lambda scenario: run(scenario, tracks={**run(scenario).tracks, track: nowhere}))
    assert results['moving_leader_is_followed'].earned == results['standing_leader_is_reached'].earned == 0
    assert 'grader_broke' not in statuses(results).values()


def test_a_turtle_that_is_put_at_its_goal_does_not_drive_there() -> None:
    def put(scenario: Scenario) -> FakeRecording:
        tracks = run(scenario).tracks
        before = [(t, 1.0, 1.0) for t in TIMES if t <= 2.0]
        return run(scenario, tracks={**tracks, '/turtle2/pose': before + tracks['/turtle2/pose']})

    results = graded('follow', put)
    assert statuses(results) == {'standing_leader_is_reached': 'failed', 'moving_leader_is_followed': 'not_run'}
    assert results['standing_leader_is_reached'].reason == 'turtle2 jumps in the run with no arguments'
