"""Frames in their root."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.composing import heading, multiplied, placed, rotated
from edulaunch.recording.records import Frame


def turned(yaw: float) -> tuple[float, float, float, float]:
    return (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))


def frame(parent: str, x: float, y: float, yaw: float = 0.0) -> Frame:
    return Frame(parent, (x, y, 0.0), turned(yaw), False, 0.0)


def test_a_chain_of_frames_is_composed_into_its_root() -> None:
    found = placed({'carrot1': frame('turtle1', 0.0, 2.0), 'turtle1': frame('world', 5.0, 5.0, math.pi / 2)})
    assert list(found) == ['world', 'turtle1', 'carrot1']
    assert found['carrot1'].root == 'world'
    assert found['carrot1'].position == pytest.approx((3.0, 5.0, 0.0))
    assert heading(found['carrot1'].turn) == pytest.approx(math.pi / 2)


def test_trees_that_are_not_connected_keep_roots_of_their_own() -> None:
    found = placed({'a': frame('world', 1, 0), 'b': frame('base', 1, 0)})
    assert {name: place.root for name, place in found.items()} == {'world': 'world', 'base': 'base', 'a': 'world', 'b': 'base'}


def test_a_loop_of_parents_does_not_run_for_ever() -> None:
    found = placed({'a': frame('b', 1, 0), 'b': frame('a', 1, 0)})
    assert sorted(found) == ['a', 'b'] and len({place.root for place in found.values()}) == 1


angles = st.floats(-3, 3)


@given(angles, angles)
def test_turns_add_up(one: float, other: float) -> None:
    vector = rotated(multiplied(turned(one), turned(other)), (1.0, 0.0, 0.0))
    assert vector == pytest.approx((math.cos(one + other), math.sin(one + other), 0.0), abs=1e-9)
