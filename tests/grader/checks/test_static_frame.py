"""What the rubric of static_frame says of made-up runs."""

from __future__ import annotations

from math import cos, sin
from typing import Any

import pytest
from edugrade import Scenario
from fake_recording import graded
from fake_runs import FakeRun, declared, frame, statuses

LEFT = (0.0, 0.0, sin(1.5708 / 2), cos(1.5708 / 2))


def run(scenario: Scenario, **changes: Any) -> FakeRun:
    frames = {
        'laser': frame('base_link', 0.2, 0.0, float(scenario.arguments.get('height', 0.5)), is_static=True),
        'camera': frame('laser', 0.0, 0.0, 0.1, LEFT, is_static=True),
        **changes,
    }
    kept = {name: item for name, item in frames.items() if item is not None}
    return FakeRun(launch=declared('height', '0.5'), frames=lambda time_s: kept, duration_s=scenario.duration_s)


def test_a_correct_launch_passes_everything() -> None:
    results = graded('static_frame', run)
    assert statuses(results) == {}
    assert sum(result.earned for result in results.values()) == 12


def test_a_fixed_height_fails_and_shows_both_places() -> None:
    fixed = frame('base_link', 0.2, 0.0, 0.5, is_static=True)
    result = graded('static_frame', lambda scenario: run(scenario, laser=fixed))['laser_is_in_its_place']
    assert (result.status, result.seen) == ('failed', 'x, y, z = (0.20, 0.00, 0.50) m')
    assert result.expected.startswith('x, y, z = (0.20, 0.00, 0.')


def test_degrees_are_not_radians() -> None:
    degrees = frame('laser', 0.0, 0.0, 0.1, (0.0, 0.0, sin(45.0), cos(45.0)), is_static=True)
    results = graded('static_frame', lambda scenario: run(scenario, camera=degrees))
    assert statuses(results) == {'camera_is_in_its_place': 'failed'}
    assert 'angles are in radians' in results['camera_is_in_its_place'].try_


def test_a_camera_in_base_link_hangs_in_the_wrong_frame() -> None:
    wrong = frame('base_link', 0.2, 0.0, 0.6, LEFT, is_static=True)
    results = graded('static_frame', lambda scenario: run(scenario, camera=wrong))
    assert (results['camera_is_on_tf'].expected, results['camera_is_on_tf'].seen) == ('the parent laser', 'the parent base_link')
    assert results['camera_is_in_its_place'].root_cause == 'camera_is_on_tf'


def test_a_root_is_a_frame_without_a_parent() -> None:
    results = graded('static_frame', lambda scenario: run(scenario, laser=None, other=frame('world', 0.0, 0.0, is_static=True)))
    assert results['laser_is_on_tf'].reason == 'the frame laser has no parent'
    assert results['laser_is_on_tf'].seen == 'camera (parent laser), other (parent world)'


def test_a_misspelt_parent_is_to_be_written_right() -> None:
    wrong = frame('base_lnk', 0.2, 0.0, 0.5, is_static=True)
    result = graded('static_frame', lambda scenario: run(scenario, laser=wrong), wrote="frame = 'base_lnk'")['laser_is_on_tf']
    assert result.try_ == 'write "base_link" instead of "base_lnk"'


def test_a_leaning_camera_is_not_turned_to_the_left() -> None:
    leaning = frame('laser', 0.0, 0.0, 0.1, (sin(0.5), 0.0, 0.0, cos(0.5)), is_static=True)
    assert 'tilt' in graded('static_frame', lambda scenario: run(scenario, camera=leaning))['camera_is_in_its_place'].seen


def test_a_frame_that_is_sent_again_and_again_is_not_static() -> None:
    def moving(scenario: Scenario) -> FakeRun:
        return run(scenario, camera=frame('laser', 0.0, 0.0, 0.1, LEFT))

    assert statuses(graded('static_frame', moving)) == {'frames_are_static': 'failed'}


def test_without_frames_nothing_is_known() -> None:
    results = graded('static_frame', lambda scenario: run(scenario, laser=None, camera=None))
    assert results['laser_is_on_tf'].seen == 'no frames'
    assert results['frames_are_static'].root_cause == 'laser_is_on_tf'


def sent_from(time_s: float, scenario: Scenario, **wrong: Any) -> FakeRun:
    """The right frames from a time on, wrong ones or none before it."""
    right, before = run(scenario), run(scenario, **wrong)
    return FakeRun(
        launch=right.launch,
        duration_s=scenario.duration_s,
        frames=lambda now: right.frames(now) if now >= time_s else before.frames(now),
    )


def test_a_frame_that_is_right_in_the_last_instant_only_comes_too_late() -> None:
    results = graded('static_frame', lambda scenario: sent_from(4.5, scenario, laser=None))
    assert results['laser_is_on_tf'].seen.startswith('the frame is first published at 4.50 s')


def test_a_frame_that_was_elsewhere_first_is_not_in_its_place() -> None:
    low = frame('base_link', 0.2, 0.0, 0.0, is_static=True)
    results = graded('static_frame', lambda scenario: sent_from(4.5, scenario, laser=low))
    assert statuses(results) == {'laser_is_in_its_place': 'failed'}
    assert results['laser_is_in_its_place'].seen == 'x, y, z = (0.20, 0.00, 0.00) m'


def test_a_frame_that_hung_elsewhere_first_is_told_with_its_time() -> None:
    wrong = frame('world', 0.2, 0.0, 0.5, is_static=True)
    results = graded('static_frame', lambda scenario: sent_from(4.5, scenario, laser=wrong))
    assert results['laser_is_on_tf'].seen == 'the parent world at 0.00 s'


@pytest.mark.parametrize('number', [float('nan'), float('inf'), 1e200])
def test_a_frame_that_is_not_a_number_is_in_no_place(number: float) -> None:
    wrong = {
        'laser': frame('base_link', number, number, number, is_static=True),
        'camera': frame('laser', 0.0, 0.0, number, (number,) * 4, is_static=True),
    }
    results = graded('static_frame', lambda scenario: run(scenario, **wrong))
    failed = dict.fromkeys(('laser_is_in_its_place', 'camera_is_in_its_place'), 'failed')
    assert statuses(results) == {**failed, 'argument_is_declared': 'not_run'}
    turned = frame('laser', 0.0, 0.0, 0.1, (0.0, 0.0, number, number), is_static=True)
    assert statuses(graded('static_frame', lambda s: run(s, camera=turned))) == {'camera_is_in_its_place': 'failed'}


def test_a_moving_frame_that_stops_coming_is_not_there_to_the_end() -> None:
    def stops(scenario: Scenario) -> FakeRun:
        moving = run(scenario, camera=frame('laser', 0.0, 0.0, 0.1, LEFT))
        gone = run(scenario, camera=None)
        return FakeRun(
            launch=moving.launch,
            duration_s=scenario.duration_s,
            frames=lambda now: moving.frames(now) if now < 2.0 else gone.frames(now),
        )

    assert graded('static_frame', stops)['camera_is_on_tf'].seen == 'the frame is first published at 0.00 s, and last at 1.50 s'


def test_a_laser_that_is_turned_is_not_in_its_place() -> None:
    def turned(scenario: Scenario) -> FakeRun:
        place = run(scenario).frames(0.0)['laser'].translation
        return run(scenario, laser=frame('base_link', *place, (0.0, 0.0, 0.5, 0.75**0.5), is_static=True))

    results = graded('static_frame', turned)
    assert statuses(results) == {'laser_is_in_its_place': 'failed'}
    assert results['laser_is_in_its_place'].seen == 'a yaw of 1.05 rad and a tilt of 0.00 rad'
