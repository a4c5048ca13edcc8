"""Convert columns of numbers and strings to short plain data: the steps from one value to the next.

The data of a number column are a list of steps, in units of the column's scale. `[n]` means n steps of 0, and `null` means a
value that is not finite. In a string column, `null` means that the previous string is repeated.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

FINE = 10_000
"""Floats are rounded to a tenth of a millimetre (or of a milliradian)."""


def number_steps(values: Iterable[float], scale: int, before: int = 0) -> tuple[list[Any], int]:
    """Return the steps of a column, and its last value for the next delta.

    Values that are not finite, or too large for a browser's numbers, become None. The step after None starts from the last
    number.

    :param values: the values of the column.
    :param scale: the number of steps in one unit.
    :param before: the last value of the previous delta, in steps.
    """
    steps: list[Any] = []
    still = 0
    last: float | None = None
    for value in values:
        if value == last:  # most values of a turtle rarely change
            still += 1
            continue
        scaled = value * scale
        if not -9e15 < scaled < 9e15:  # also false for NaN
            _still(steps, still)
            still = 0
            steps.append(None)
            continue
        last = value
        whole = round(scaled)
        if whole == before:
            still += 1
            continue
        if still:
            _still(steps, still)
            still = 0
        steps.append(whole - before)
        before = whole
    _still(steps, still)
    return steps, before


def _still(steps: list[Any], count: int) -> None:
    """Append `count` steps of 0, in the short form if `count` is more than 2."""
    if count > 2:
        steps.append([count])
    else:
        steps.extend([0] * count)


def text_steps(values: Iterable[str], before: str | None = None) -> tuple[list[str | None], str | None]:
    """Return the strings, with None for each repeated string, and the last string for the next delta.

    :param values: the strings of the column.
    :param before: the last string of the previous delta, or None.
    """
    steps: list[str | None] = []
    for value in values:
        steps.append(None if value == before else value)
        before = value
    return steps, before
