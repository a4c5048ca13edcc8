"""Columns of numbers and strings as short plain data: steps from one value to the next.

A number column is a list of steps in units of its scale. In it, `[n]` means n steps of 0, and `null` means a value that
is not finite. A string column has `null` for a repeated string.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

FINE = 10_000
"""Floats are rounded to a tenth of a millimetre (or of a milliradian)."""


def number_steps(values: Iterable[float], scale: int, before: int = 0) -> tuple[list[Any], int]:
    """Return the steps of a column from the value `before` (in scaled units), and the last value for the next delta.

    Values that are not finite, or too large for a browser's numbers, become None. The next step starts from the value before.
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
    """Append `count` steps of 0, in the short form if there is one."""
    if count > 2:
        steps.append([count])
    else:
        steps.extend([0] * count)


def text_steps(values: Iterable[str], before: str | None = None) -> tuple[list[str | None], str | None]:
    """Return the strings, with None for each string that equals the previous one."""
    steps: list[str | None] = []
    for value in values:
        steps.append(None if value == before else value)
        before = value
    return steps, before
