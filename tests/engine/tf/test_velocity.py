"""Velocities from the buffer."""

from __future__ import annotations

from math import pi

import pytest

from edulaunch.engine.tf import TransformBuffer
from edulaunch.engine.tf.velocity import lookup_velocity

from .shapes import SECOND, at


def moving(speed: float, turn: float) -> TransformBuffer:
    buffer = TransformBuffer()
    for tenth in range(10, 31):
        buffer.set('world', 'robot', tenth * SECOND // 10, at(speed * tenth / 10, yaw=turn * tenth / 10))
    return buffer


@pytest.mark.parametrize('time_ns', [0, 2 * SECOND])
def test_an_even_motion_has_its_speed_and_its_turn_rate(time_ns):
    linear, angular = lookup_velocity(moving(2.0, 0.5), 'robot', 'world', time_ns, SECOND)
    assert linear == pytest.approx((2.0, 0.0, 0.0))
    assert angular == pytest.approx((0.0, 0.0, 0.5))


def test_a_frame_at_rest_has_none():
    assert lookup_velocity(moving(0.0, 0.0), 'robot', 'world', 0, SECOND) == ((0.0,) * 3, (0.0,) * 3)


def speeding(times_and_places: list[tuple[float, float]]) -> TransformBuffer:
    buffer = TransformBuffer()
    for time_s, x in times_and_places:
        buffer.set('world', 'robot', round(time_s * SECOND), at(x, 2 * x))
    return buffer


@pytest.mark.parametrize(
    ('time_s', 'averaging_s', 'speed'),
    [
        (0.0, 2.0, 3.0),  # 2 s to 4 s, the latest ones
        (2.0, 2.0, 2.0),  # 1 s to 3 s: the time is the middle
        (3.5, 2.0, 3.0),  # it cannot end after 4 s, so it moves back
        (2.0, 1.0, 2.0),  # 1.5 s to 2.5 s, between the data
    ],
)
def test_the_time_span_has_the_time_in_its_middle_and_moves_back_at_the_end(
    time_s: float, averaging_s: float, speed: float
) -> None:
    buffer = speeding([(1.0, 0.0), (2.0, 1.0), (3.0, 4.0), (4.0, 7.0)])
    linear, angular = lookup_velocity(buffer, 'robot', 'world', round(time_s * SECOND), round(averaging_s * SECOND))
    assert linear == pytest.approx((speed, 2 * speed, 0.0))
    assert angular == (0.0, 0.0, 0.0)


def test_a_time_span_of_nothing_has_no_velocity() -> None:
    assert lookup_velocity(speeding([(1.0, 0.0), (2.0, 1.0)]), 'robot', 'world', 0, 0) == ((0.0,) * 3, (0.0,) * 3)


@pytest.mark.parametrize(('turn', 'rate'), [(3.0, 3.0), (4.0, 4.0 - 2 * pi), (-1.5, -1.5)])
def test_a_turn_is_taken_in_the_shorter_direction(turn: float, rate: float) -> None:
    buffer = TransformBuffer()
    for second, yaw in ((1, 0.0), (2, turn)):
        buffer.set('world', 'robot', second * SECOND, at(0.0, yaw=yaw))
    assert lookup_velocity(buffer, 'robot', 'world', 0, SECOND)[1] == pytest.approx((0.0, 0.0, rate))
