"""Recordings made by hand, as the tests of the canvas make them, and columns read as the page reads them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

from tests.canvas.conftest import demo, maker, walk

__all__ = ['demo', 'maker', 'numbers', 'walk']


def numbers(steps: Iterable[Any], scale: int, before: int = 0) -> list[float]:
    """The values that `edulaunch.desk.view.columns.number_steps` was given, to the scale: the page's own reading."""
    found: list[float] = []
    for step in steps:
        if step is None:
            found.append(math.nan)
        elif isinstance(step, list):
            found += [before / scale] * step[0]
        else:
            before += step
            found.append(before / scale)
    return found
