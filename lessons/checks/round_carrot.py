"""The check of lesson 10, your turn: a carrot that moves in a circle."""

from __future__ import annotations

from collections.abc import Sequence

from edugrade import Evidence, Failure, Mismatch, Rubric, Scenario, check
from edugrade.library.frames import require_frame

PROGRAM = 'dynamic_frame_tf2_broadcaster.py'
RADIUS_M, PERIOD_S = 2.0, 10.0


def places(run: Evidence, times_s: Sequence[float]) -> list[complex]:
    """Return the positions of carrot1 relative to turtle1, as complex numbers."""
    found = [run.first.frames_at(time_s).get('carrot1') for time_s in times_s]
    if None in found:
        raise Failure(
            'carrot1 is not in the tf tree all the time',
            where=run.source.place_in(PROGRAM, 'sendTransform'),
            try_='check when the broadcaster stops',
        )
    return [complex(*frame.translation[:2]) for frame in found if frame is not None]


@check(points=1)
def carrot_is_there(run: Evidence) -> None:
    """The frame carrot1 has the parent turtle1"""
    require_frame(run, 'carrot1', 'turtle1', f'look at {PROGRAM}')


@check(points=1, needs=[carrot_is_there])
def it_is_two_metres_away(run: Evidence) -> None:
    """carrot1 is always 2 m away from turtle1"""
    far = [abs(place) for place in places(run, (2.05, 3.3, 4.55, 7.05))]
    if not all(abs(away - RADIUS_M) < 0.005 for away in far):
        seen = ', '.join(f'{away:.2f} m' for away in far)
        raise Mismatch(
            'the distance',
            f'{RADIUS_M:g} m',
            seen,
            where=run.source.place_in(PROGRAM, 'x, y = '),
            try_='check the number for the radius',
        )


@check(points=1, needs=[carrot_is_there])
def it_moves_smoothly(run: Evidence) -> None:
    """carrot1 moves smoothly"""
    one, two = places(run, (4.05, 4.15))
    if not 0.01 < abs(two - one) < 0.5:
        raise Failure(
            'carrot1 does not move, or it jumps',
            expected='a few centimetres in a tenth of a second',
            seen=f'{abs(two - one):.2f} m',
            where=run.source.place_in(PROGRAM, 'seconds'),
            try_='use .nanoseconds, because whole seconds are too coarse',
        )


@check(points=1, needs=[it_moves_smoothly])
def it_goes_round_once_in_ten_seconds(run: Evidence) -> None:
    """The carrot makes one turn in 10 s, so after 5 s it is on the opposite side"""
    start, half, whole = places(run, (2.05, 2.05 + PERIOD_S / 2, 2.05 + PERIOD_S))
    if not (abs(start - whole) < 0.1 and abs(start + half) < 0.1):
        raise Failure(
            'the position after half a turn or after a whole turn is wrong',
            expected=f'at {-start:.2f} after 5 s, at {start:.2f} after 10 s',
            seen=f'at {half:.2f} and at {whole:.2f}',
            where=run.source.place_in(PROGRAM, 'pi'),
            try_='divide 2 pi, a whole turn, by the number of seconds',
        )


RUBRIC = Rubric(
    title='A carrot that moves in a circle',
    decoys=1.0,  # the student's own program may publish the same frames in any way
    of='my_ws/src/learning_tf2_py/launch/turtle_tf2_dynamic_frame_demo.launch.py',
    scenarios=lambda random: [Scenario('run', {}, 14.0)],
    checks=[carrot_is_there, it_is_two_metres_away, it_moves_smoothly, it_goes_round_once_in_ten_seconds],
)
