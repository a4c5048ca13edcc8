"""Lines with fewer points."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.thinning import thinned

points = st.lists(st.tuples(st.floats(0, 11), st.floats(0, 11)), min_size=2, max_size=40)


def distance_to_line(point: tuple[float, float], line: list[tuple[float, float]]) -> float:
    def to_stretch(a: tuple[float, float], b: tuple[float, float]) -> float:
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = dx * dx + dy * dy
        part = 0.0 if length == 0 else max(0.0, min(1.0, ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / length))
        return math.hypot(point[0] - a[0] - part * dx, point[1] - a[1] - part * dy)

    return min(to_stretch(a, b) for a, b in zip(line, line[1:], strict=False))


def test_points_on_a_straight_line_are_left_out() -> None:
    assert thinned([(x / 10, 1.0) for x in range(11)]) == [(0.0, 1.0), (1.0, 1.0)]


def test_a_corner_stays() -> None:
    assert thinned([(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 1.0)]) == [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]


def test_going_back_on_the_same_line_keeps_the_turning_point() -> None:
    assert thinned([(0.0, 0.0), (1.0, 0.0), (0.5, 0.0)]) == [(0.0, 0.0), (1.0, 0.0), (0.5, 0.0)]


def test_a_slow_curve_does_not_drift_away() -> None:
    circle = [(math.cos(step / 200), math.sin(step / 200)) for step in range(1257)]
    kept = thinned(circle)
    assert len(kept) < 100
    assert max(distance_to_line(point, kept) for point in circle) <= 0.0021


@given(points)
def test_thinning_keeps_both_ends_and_invents_nothing(line: list[tuple[float, float]]) -> None:
    kept = thinned(line)
    assert (kept[0], kept[-1]) == (line[0], line[-1])
    assert all(point in line for point in kept)


@given(points)
def test_no_point_left_out_is_further_off_than_the_tolerance(line: list[tuple[float, float]]) -> None:
    kept = thinned(line, 0.01)
    assert max(distance_to_line(point, kept) for point in line) <= 0.0101
