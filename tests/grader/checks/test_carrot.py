"""What the rubric of carrot says of made-up runs."""

from __future__ import annotations

from typing import Any

from edugrade import Scenario
from fake_recording import FILE, Track, graded
from fake_runs import FakeRun, circles, declared, frame, node, program, statuses, stays

from edulaunch.engine.recording.records import Parameter

LISTENER = program(1, 'turtle_tf2_py', 'turtle_tf2_listener')
FIXED = program(2, 'turtle_tf2_py', 'fixed_frame_tf2_broadcaster')
MOVING = program(3, 'turtle_tf2_py', 'dynamic_frame_tf2_broadcaster')


def comes(x: float, y: float) -> Track:
    """Two seconds' drive to a place, and then rest."""
    return [(t, x, y - max(0.0, 2.0 - t)) for t, _, _ in stays(x, y)]


def run(scenario: Scenario, **changes: Any) -> FakeRun:
    moves = scenario.arguments.get('carrot') == 'moving'

    def at(time_s: float) -> tuple[float, float]:
        track = circles(3.0, 1.0) if moves else comes(5.5, 7.5)
        return track[round(time_s * 10)][1:] if round(time_s * 10) < len(track) else track[-1][1:]

    def frames(time_s: float) -> Any:
        side = (10.0 if int(time_s) % 2 else -10.0) if moves else 2.0
        return {
            'turtle1': frame('world', 5.5, 5.5),
            'turtle2': frame('world', *at(time_s)),
            'carrot1': frame('turtle1', 0.0, side),
        }

    return FakeRun(
        **{
            'launch': declared('carrot', 'fixed'),
            'processes': [LISTENER, MOVING if moves else FIXED],
            'nodes': [node('/listener', LISTENER)],
            'frames': frames,
            'values': {'/listener': {'target_frame': Parameter('carrot1', 'launch argument target_frame')}},
            'tracks': {'/turtle2/pose': circles(3.0, 1.0) if moves else comes(5.5, 7.5)},
            **changes,
        }
    )


def test_a_correct_launch_passes_everything() -> None:
    results = graded('carrot', run)
    assert statuses(results) == {}
    assert sum(result.earned for result in results.values()) == 12


def test_both_broadcasters_at_once_are_named() -> None:
    result = graded('carrot', lambda s: run(s, processes=[LISTENER, FIXED, MOVING]))['one_carrot_at_a_time']
    assert result.seen == 'fixed_frame_tf2_broadcaster and dynamic_frame_tf2_broadcaster'
    assert result.try_.endswith("(LaunchConfiguration('carrot'), 'moving'))")


def test_the_default_is_the_fixed_one() -> None:
    result = graded('carrot', lambda s: run(s, launch=declared('carrot', "'moving'")))['default_is_fixed']
    assert (result.expected, result.seen, result.where) == ('fixed', 'moving', (FILE, 3))


def test_a_listener_that_follows_turtle1_is_told_where_its_value_comes_from() -> None:
    values = {'/listener': {'target_frame': Parameter('turtle1', 'default')}}
    results = graded('carrot', lambda s: run(s, values=values))
    assert results['carrot_is_the_target'].seen == 'turtle1, the default value'
    assert results['fixed_carrot_is_reached'].root_cause == 'carrot_is_the_target'


def test_a_turtle_far_from_the_fixed_carrot_fails() -> None:
    results = graded('carrot', lambda s: run(s, tracks={'/turtle2/pose': stays(5.5, 5.5)}))
    assert statuses(results) == {'fixed_carrot_is_reached': 'failed', 'moving_carrot_is_chased': 'failed'}
    assert results['fixed_carrot_is_reached'].seen.startswith('2.00 m away at ')


def test_a_carrot_that_does_not_swing_is_not_the_moving_one() -> None:
    still = run(Scenario('fixed', {'carrot': 'fixed'})).frames
    results = graded('carrot', lambda s: run(s, frames=still))
    assert results['moving_carrot_swings'].seen == '2.0 m to the left and 2.0 m to the left'


def test_a_wrong_default_costs_its_own_point_only() -> None:
    assert statuses(graded('carrot', lambda s: run(s, launch=declared('carrot', "'moving'")))) == {'default_is_fixed': 'failed'}


def test_carrots_that_are_right_in_the_last_instant_only_do_not_count() -> None:
    def late(scenario: Scenario) -> FakeRun:
        right = run(scenario).frames
        aside = {**right(0.0), 'carrot1': frame('turtle1', 5.0, 0.0)}
        return run(scenario, frames=lambda time_s: right(time_s) if time_s >= 18.0 else aside)

    results = statuses(graded('carrot', late))
    assert results['fixed_carrot_hangs'] == results['moving_carrot_swings'] == 'failed'


def test_a_carrot_that_is_not_a_number_hangs_nowhere() -> None:
    def nowhere(scenario: Scenario) -> FakeRun:
        frames = run(scenario).frames
        return run(scenario, frames=lambda time_s: {**frames(time_s), 'carrot1': frame('turtle1', float('nan'), float('nan'))})

    results = statuses(graded('carrot', nowhere))
    assert results['fixed_carrot_hangs'] == results['moving_carrot_swings'] == 'failed'
    assert 'grader_broke' not in results.values()
