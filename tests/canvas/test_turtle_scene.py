"""Turtle windows as data."""
from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.turtle_scene import thinned

points = st.lists(st.tuples(st.floats(0, 11), st.floats(0, 11)), min_size=2, max_size=40)


def test_points_on_a_straight_line_are_left_out() -> None:
    assert thinned([(x / 10, 1.0) for x in range(11)]) == [(0.0, 1.0), (1.0, 1.0)]


def test_a_corner_stays() -> None:
    assert thinned([(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 1.0)]) == [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]


@given(points)
def test_thinning_keeps_both_ends_and_invents_nothing(line: list[tuple[float, float]]) -> None:
    kept = thinned(line)
    assert (kept[0], kept[-1]) == (line[0], line[-1])
    assert all(point in line for point in kept)
