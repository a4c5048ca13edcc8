"""Steps give back the values, and deltas fit behind each other."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.desk.view.columns import FINE, number_steps, text_steps
from tests.desk.view.conftest import numbers

VALUES = st.lists(st.floats(-1e6, 1e6) | st.just(0.0) | st.sampled_from([math.nan, math.inf, -math.inf, 1e300]))


@given(VALUES, st.integers(0, 20))
def test_steps_in_two_deltas_give_the_values_to_the_scale(values: list[float], cut: int) -> None:
    first, last = number_steps(values[:cut], FINE)
    second, _ = number_steps(values[cut:], FINE, last)
    found = numbers(first, FINE) + numbers(second, FINE, last)
    assert len(found) == len(values)
    for value, told in zip(values, found, strict=True):
        if math.isfinite(value) and abs(value) < 1e11:
            assert told == pytest.approx(value, abs=0.6 / FINE)
        else:
            assert math.isnan(told)


def test_what_stands_still_is_short() -> None:
    assert number_steps([1.5] * 1000 + [1.6], FINE) == ([15000, [999], 1000], 16000)


def test_a_value_that_is_not_finite_changes_nothing() -> None:
    assert number_steps([1, math.nan, 1, 2], 1) == ([1, None, 0, 1], 2)


def test_equal_texts_are_told_once_also_over_pieces() -> None:
    assert text_steps(['a', 'a', 'b'], 'a') == ([None, None, 'b'], 'b')
