"""Rotations: the algebra, and tf2's choice between q and -q."""

from __future__ import annotations

from math import copysign, cos, isnan, nan, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.tf.quaternions import (
    IDENTITY,
    canonical,
    conjugate,
    from_euler,
    from_matrix,
    multiply,
    rotate,
    to_euler,
    to_matrix,
)

from .shapes import angles, numbers, rotations


@given(rotations)
def test_a_rotation_times_its_conjugate_is_the_identity(q):
    assert multiply(q, conjugate(q)) == pytest.approx(IDENTITY, abs=1e-12)


@given(rotations, rotations, numbers, numbers, numbers)
def test_a_product_rotates_by_the_right_factor_first(a, b, x, y, z):
    assert rotate(multiply(a, b), (x, y, z)) == pytest.approx(rotate(a, rotate(b, (x, y, z))), abs=1e-9)


@given(angles, angles)
def test_turns_about_one_axis_add_up(one, other):
    turned = rotate(multiply(from_euler(0.0, 0.0, one), from_euler(0.0, 0.0, other)), (1.0, 0.0, 0.0))
    assert turned == pytest.approx((cos(one + other), sin(one + other), 0.0), abs=1e-9)


@given(rotations)
def test_canonical_equals_the_way_through_a_matrix(q):
    assert canonical(q) == pytest.approx(from_matrix(to_matrix(q)), abs=1e-7)


@given(rotations, st.floats(0.01, 50.0))
def test_canonical_ignores_length_and_sign(q, length):
    scaled = tuple(value * -length for value in q)
    assert canonical(scaled) == pytest.approx(canonical(q), abs=1e-9)


@pytest.mark.parametrize(
    ('yaw', 'expected'),
    [
        (2.0, (0.0, 0.0, 0.841471, 0.540302)),
        (pi + 0.07, (0.0, 0.0, 0.999388, -0.034993)),
        (-2.5, (0.0, 0.0, 0.948985, -0.315322)),
        (-2.0, (0.0, 0.0, -0.841471, 0.540302)),
    ],
)
def test_beyond_120_degrees_the_largest_of_xyz_is_positive_and_w_may_be_negative(yaw, expected):
    assert canonical(from_euler(0.0, 0.0, yaw)) == pytest.approx(expected, abs=1e-6)


def test_a_tie_of_120_degrees_is_settled_for_x():
    assert canonical((-0.5, -0.5, -0.5, 0.5)) == (0.5, 0.5, 0.5, -0.5)


@pytest.mark.parametrize('q', [(0.0, 0.0, 0.0, 0.0), (nan, 0.0, 0.0, 1.0), (float('inf'), 0.0, 0.0, 1.0)])
def test_what_is_no_rotation_becomes_nan(q):
    assert all(isnan(value) for value in canonical(q))


@given(angles, st.floats(-1.5, 1.5), angles)
def test_euler_angles_survive_the_round_trip(roll, pitch, yaw):
    assert to_euler(from_euler(roll, pitch, yaw)) == pytest.approx((roll, pitch, yaw), abs=1e-6)


@pytest.mark.parametrize('pitch', [pi / 2, -pi / 2])
def test_at_vertical_pitch_yaw_is_zero(pitch):
    roll, found, yaw = to_euler(from_euler(0.0, pitch, 0.0))
    assert (found, yaw) == (pytest.approx(pitch, abs=1e-7), pytest.approx(0.0, abs=1e-7))


@pytest.mark.parametrize('axis', [0, 1, 2])
@pytest.mark.parametrize('sign', [1.0, -1.0])
def test_half_a_turn_has_its_axis_positive(axis, sign):
    q = [0.0, 0.0, 0.0, 0.0]
    q[axis] = sign
    expected = tuple(abs(value) for value in q)
    assert canonical(tuple(q)) == from_matrix(to_matrix(tuple(q))) == expected
    assert str(canonical(tuple(q))) == str(expected), 'no negative zeros'


@pytest.mark.parametrize('q', [(0.1, -0.6, 0.5, 0.4), (0.5, 0.1, -0.6, 0.4), (-0.6, 0.5, 0.1, -0.4), (-0.6, -0.6, 0.1, 0.1)])
def test_the_largest_part_decides_beyond_120_degrees(q):
    shown = canonical(q)
    assert max(shown[:3], key=abs) > 0.0
    assert shown == pytest.approx(from_matrix(to_matrix(q)), abs=1e-12)


@pytest.mark.parametrize('length', [1e-60, 1e-20, 1e20, 1e60])
def test_very_short_and_very_long_ones_are_rotations(length):
    assert canonical((0.0, 0.0, -0.6 * length, -0.8 * length)) == pytest.approx((0.0, 0.0, 0.6, 0.8))


def test_a_turn_by_known_angles():
    assert from_euler(0.1, 0.2, 0.3) == pytest.approx((0.034270798, 0.106020511, 0.143572175, 0.983347443))
    assert to_matrix(from_euler(0.0, 0.0, pi / 2)) == (
        pytest.approx((0.0, -1.0, 0.0)),
        pytest.approx((1.0, 0.0, 0.0)),
        pytest.approx((0.0, 0.0, 1.0)),
    )
    assert to_euler((0.0, 0.0, 0.0, 2.0)) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize('up', [1.0, -1.0])
def test_at_exactly_vertical_pitch_the_rest_of_the_turn_is_lost_as_in_tf2(up):
    """The quaternions have whole numbers, so that the last row of the matrix is exactly (-1, 0, 0) or (1, 0, 0)."""
    vertical = multiply((0.0, up, 0.0, 1.0), (3.0 * up, 0.0, 0.0, 4.0))
    assert to_euler(vertical) == (0.0, up * pi / 2, 0.0)


def test_what_is_no_rotation_has_the_sign_of_tf2():
    assert str(canonical((0.0, 0.0, 0.0, 0.0))) == '(nan, nan, nan, nan)'
    assert [copysign(1.0, value) for value in canonical((0.0, 0.0, 0.0, 0.0))] == [-1.0] * 4
