"""Ticks, and metres to pixels."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.labels import Box
from edulaunch.canvas.panel import Panel, tick_text, ticks
from edulaunch.canvas.paper import Paper


@pytest.mark.parametrize(
    ('limits', 'expected'),
    [((0.0, 11.088889), [0, 2, 4, 6, 8, 10]), ((0.0, 1.0), [0, 0.2, 0.4, 0.6, 0.8, 1.0]), ((-7.0, 13.0), [-5, 0, 5, 10])],
)
def test_ticks_are_round_numbers_between_the_limits(limits: tuple[float, float], expected: list[float]) -> None:
    assert ticks(*limits) == pytest.approx(expected)


@given(st.floats(-100, 100), st.floats(0.01, 200))
def test_there_are_never_more_ticks_than_asked_for(low: float, span: float) -> None:
    assert len(ticks(low, low + span)) <= 7


def test_a_tick_has_the_decimals_of_its_step() -> None:
    assert [tick_text(0.30000000000000004, 0.1), tick_text(-0.0, 1), tick_text(10, 5), tick_text(0.25, 0.05)] == [
        '0.3',
        '0',
        '10',
        '0.25',
    ]


def test_the_corners_of_the_world_are_the_corners_of_the_panel() -> None:
    panel = Panel(Paper(100, 100), Box(10, 20, 90, 80), (0.0, 8.0, -3.0, 3.0))
    assert [panel.at(0, -3), panel.at(8, 3), panel.at(4, 0)] == [(10, 20), (90, 80), (50, 50)]
