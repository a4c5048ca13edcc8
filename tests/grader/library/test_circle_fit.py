"""The fitted circle is the circle that the points lie on."""

from __future__ import annotations

from math import cos, pi, sin

import pytest
from edugrade.library.circle_fit import fit_circle
from hypothesis import given
from hypothesis import strategies as st


def points(x: float, y: float, radius: float, arc: float = 2.0, count: int = 40) -> list[tuple[float, float]]:
    return [(x + radius * cos(arc * k / count), y + radius * sin(arc * k / count)) for k in range(count)]


@given(x=st.floats(-100, 100), y=st.floats(-100, 100), radius=st.floats(0.1, 10), arc=st.floats(0.5, 2 * pi))
def test_a_circle_is_found_again_from_a_piece_of_it(x: float, y: float, radius: float, arc: float) -> None:
    circle = fit_circle(points(x, y, radius, arc))
    assert circle is not None
    assert circle.radius == pytest.approx(radius, rel=1e-4)
    assert (circle.x, circle.y) == pytest.approx((x, y), abs=1e-3 * radius)
    assert circle.residual < 1e-4 * radius


def test_a_line_has_no_circle() -> None:
    assert fit_circle([(0.1 * k, 0.2 * k) for k in range(50)]) is None


def test_a_robot_that_stands_has_no_circle() -> None:
    assert fit_circle([(1.0, 2.0)] * 50) is None


def test_two_points_have_no_circle() -> None:
    assert fit_circle([(0.0, 0.0), (1.0, 0.0)]) is None


def test_a_square_is_far_from_its_circle() -> None:
    side = [k / 10 for k in range(10)]
    square = [(s, 0.0) for s in side] + [(1.0, s) for s in side] + [(1 - s, 1.0) for s in side] + [(0.0, 1 - s) for s in side]
    circle = fit_circle(square)
    assert circle is not None
    assert circle.residual > 0.05
