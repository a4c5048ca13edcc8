"""Shapes, widths and colours that all pictures share."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.style import MONO_ADVANCE, TEXT, mono_width, oval, robot, shade, shortened, turtle

lengths = st.floats(0.01, 10.0)


@given(lengths, lengths, st.integers(3, 40))
def test_an_oval_lies_on_its_ellipse(rx: float, ry: float, steps: int) -> None:
    points = oval(3.0, -2.0, rx, ry, steps=steps)
    assert len(points) == steps
    assert points[0] == (round(3.0 + rx, 3), -2.0)
    for x, y in points:
        assert math.hypot((x - 3.0) / rx, (y + 2.0) / ry) == pytest.approx(1.0, abs=0.2 if min(rx, ry) < 0.1 else 0.01)


def test_an_oval_goes_round_to_the_left_and_turns_about_its_middle() -> None:
    assert oval(0.0, 0.0, 2.0, 1.0, steps=4) == [(2.0, 0.0), (0.0, 1.0), (-2.0, 0.0), (0.0, -1.0)]
    assert oval(1.0, 0.0, 2.0, 1.0, math.pi / 2, 4) == [(1.0, 2.0), (0.0, 0.0), (1.0, -2.0), (2.0, 0.0)]
    assert len(oval(0.0, 0.0, 1.0, 1.0)) == 16


def area(points: list[tuple[float, float]]) -> float:
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in pairwise([*points, points[0]])) / 2


@pytest.mark.parametrize('parts', [turtle(), robot()])
def test_drawings_are_the_same_on_both_sides_and_look_ahead(parts: list[tuple[str, list[tuple[float, float]]]]) -> None:
    corners = {point for _, points in parts for point in points}
    mirrored = {(x, -y) for x, y in corners}
    assert all(min(math.dist(one, other) for other in mirrored) < 0.002 for one in corners)
    assert max(x for x, _ in corners) > 0.39
    assert max(abs(y) for _, y in corners) < 0.6


def test_a_turtle_has_its_parts() -> None:
    names = [name for name, _ in turtle()]
    assert {name: names.count(name) for name in dict.fromkeys(names)} == {'skin': 6, 'shell': 1, 'plate': 1, 'seam': 6, 'eye': 2}
    shell = next(points for name, points in turtle() if name == 'shell')
    assert area(shell) == pytest.approx(math.pi * 0.40 * 0.34, rel=0.02)
    eyes = [points for name, points in turtle() if name == 'eye']
    assert all(sum(x for x, _ in eye) / len(eye) == pytest.approx(0.51, abs=0.002) for eye in eyes)
    assert [name for name, _ in robot()] == ['wheel', 'wheel', 'body', 'nose']
    assert [area(points) for name, points in robot() if name == 'wheel'] == pytest.approx([0.056, -0.056])


def test_widths_of_texts() -> None:
    assert mono_width('abcd') == pytest.approx(4 * MONO_ADVANCE * TEXT)
    assert mono_width('ab', 10.0) == pytest.approx(20 * MONO_ADVANCE)


@pytest.mark.parametrize(('text', 'most', 'shown'), [('abc', 3, 'abc'), ('abcd', 3, 'ab…'), ('', 3, '')])
def test_a_long_text_ends_in_dots(text: str, most: int, shown: str) -> None:
    assert shortened(text, most) == shown
    assert (shortened('x' * 28), shortened('x' * 29)) == ('x' * 28, 'x' * 27 + '…')


def test_a_shade_is_darker() -> None:
    assert (shade((100, 200, 50)), shade((100, 200, 50), 0.5)) == ((82, 164, 41), (50, 100, 25))
