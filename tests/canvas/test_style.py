"""Shapes, widths and colours that all pictures share."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas import style
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


def edges(points: list[tuple[float, float]]) -> tuple[float, float, float, float]:
    xs, ys = zip(*points, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def test_each_part_of_a_turtle_has_its_place_and_size() -> None:
    left = [(name, len(points), *edges(points)) for name, points in turtle() if max(y for _, y in points) > 0]
    assert left == [
        ('skin', 12, 0.13, 0.41, 0.157, 0.503),
        ('skin', 12, -0.4, -0.16, 0.161, 0.419),
        ('skin', 3, -0.54, -0.36, -0.06, 0.06),
        ('skin', 16, 0.305, 0.615, -0.12, 0.12),
        ('shell', 20, -0.4, 0.4, -0.34, 0.34),
        ('plate', 6, -0.19, 0.19, -0.147, 0.147),
        ('seam', 2, 0.095, 0.185, 0.147, 0.273),
        ('seam', 2, -0.185, -0.095, 0.147, 0.273),
        ('eye', 8, 0.484, 0.536, 0.036, 0.088),
    ]


def test_a_robot_points_ahead_and_its_wheels_are_at_its_sides() -> None:
    assert [(name, *edges(points)) for name, points in robot()] == [
        ('wheel', -0.2, 0.2, 0.3, 0.44),
        ('wheel', -0.2, 0.2, -0.44, -0.3),
        ('body', -0.4, 0.4, -0.36, 0.36),
        ('nose', -0.08, 0.32, -0.2, 0.2),
    ]


def brightness(colour: tuple[int, int, int]) -> float:
    """The relative luminance of WCAG 2."""
    linear = [part / 255 / 12.92 if part <= 10 else ((part / 255 + 0.055) / 1.055) ** 2.4 for part in colour]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: tuple[int, int, int], other: tuple[int, int, int]) -> float:
    dark, light = sorted((brightness(one), brightness(other)))
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize('ink', [style.INK, style.MUTED, style.BLUE, style.SAND, style.GREEN, style.RED])
@pytest.mark.parametrize('ground', [style.PAPER, style.BLUE_TINT, style.SAND_TINT, style.GREEN_TINT, style.RED_TINT])
def test_every_colour_of_letters_can_be_read_on_every_ground(ink: style.Colour, ground: style.Colour) -> None:
    assert contrast(ink, ground) >= 4.2
    assert contrast(style.GRID, style.PAPER) < 1.3, 'a grid stays behind'
