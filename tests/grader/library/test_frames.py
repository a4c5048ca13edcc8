"""Frames are composed along the tree, and read as a person does."""

from __future__ import annotations

from math import cos, pi, sin

import pytest
from edugrade.library.frames import numbers, place_in, tilt, yaw
from fake_runs import frame
from hypothesis import given
from hypothesis import strategies as st


def turned(angle: float) -> tuple[float, float, float, float]:
    return (0.0, 0.0, sin(angle / 2), cos(angle / 2))


def test_a_place_is_followed_up_to_the_root() -> None:
    frames = {'a': frame('world', 1.0, 2.0, rotation=turned(pi / 2)), 'b': frame('a', 3.0, 0.0)}
    assert place_in(frames, 'b', 'world') == pytest.approx((1.0, 5.0))
    assert place_in(frames, 'b', 'a') == (3.0, 0.0)


def test_where_nothing_leads_there_is_no_place() -> None:
    assert place_in({'a': frame('b', 1.0, 0.0)}, 'a', 'world') is None
    assert place_in({'a': frame('b', 1.0, 0.0), 'b': frame('a', 1.0, 0.0)}, 'a', 'world') is None


@given(st.floats(-3.1, 3.1))
def test_yaw_is_the_angle_and_there_is_no_tilt(angle: float) -> None:
    found = frame('world', 0.0, 0.0, rotation=turned(angle))
    assert (yaw(found), tilt(found)) == (pytest.approx(angle), 0.0)


def test_numbers_have_no_negative_zero() -> None:
    assert numbers((0.2, -0.0)) == '(0.20, 0.00)'
