"""Velocities from the buffer."""

from __future__ import annotations

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
