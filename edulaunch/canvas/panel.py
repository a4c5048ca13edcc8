"""A rectangle of the sheet that shows a piece of the world: metres (or other units) to pixels, frame, ticks and grid."""

from __future__ import annotations

import math
from collections.abc import Iterable

from edulaunch.canvas.labels import Box
from edulaunch.canvas.paper import Paper
from edulaunch.canvas.style import GRID, MUTED, SMALL, Colour


def ticks(low: float, high: float, most: int = 7) -> list[float]:
    """Round numbers between two limits, at most `most` of them, in steps of 1, 2 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10((high - low) / most))
    for step in (power, 2 * power, 5 * power, 10 * power, 20 * power):
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        if last - first < most:
            break
    return [number * step for number in range(first, last + 1)]


def tick_text(value: float, step: float) -> str:
    """The number of a tick, with as many decimals as the step between ticks needs."""
    return f'{value + 0.0:.{max(0, -math.floor(math.log10(step) + 1e-9))}f}'


class Panel:
    """A box on a paper with the world's `limits` (left, right, bottom, top) mapped onto it."""

    def __init__(self, paper: Paper, box: Box, limits: tuple[float, float, float, float]) -> None:
        self.paper, self.box, self.limits = paper, box, limits
        self.x_scale = (box.right - box.left) / (limits[1] - limits[0])
        self.y_scale = (box.top - box.bottom) / (limits[3] - limits[2])

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Where a place of the world is on the paper."""
        return (self.box.left + (x - self.limits[0]) * self.x_scale, self.box.bottom + (y - self.limits[2]) * self.y_scale)

    def points(self, places: Iterable[tuple[float, float]]) -> list[tuple[float, float]]:
        """Where places of the world are on the paper."""
        return [self.at(x, y) for x, y in places]

    def ground(self, colour: Colour, grid: bool) -> None:
        """The background, and a grid at the ticks."""
        left, bottom, right, top = self.box
        self.paper.box(left, bottom, right - left, top - bottom, fill=colour)
        if grid:
            for value in ticks(*self.limits[:2]):
                self.paper.line([self.at(value, self.limits[2]), self.at(value, self.limits[3])], colour=GRID, width=0.8)
            for value in ticks(*self.limits[2:]):
                self.paper.line([self.at(self.limits[0], value), self.at(self.limits[1], value)], colour=GRID, width=0.8)

    def frame(self, unit: str = '') -> None:
        """The border, with numbers at the ticks below and to the left; the last number below carries the unit."""
        left, bottom, right, top = self.box
        self.paper.box(left, bottom, right - left, top - bottom, edge=MUTED, line_width=0.8)
        across, along = ticks(*self.limits[:2]), ticks(*self.limits[2:])
        for value in across:
            x = self.at(value, 0)[0]
            self.paper.line([(x, bottom), (x, bottom - 3)], colour=MUTED, width=0.8)
            text = tick_text(value, _step(across)) + (f' {unit}' if unit and value == across[-1] else '')
            self.paper.text(x, bottom - 13, text, size=SMALL - 0.5, align='center')
        for value in along:
            y = self.at(0, value)[1]
            self.paper.line([(left, y), (left - 3, y)], colour=MUTED, width=0.8)
            self.paper.text(left - 5, y, tick_text(value, _step(along)), size=SMALL - 0.5, align='right', middle=True)


def _step(values: list[float]) -> float:
    return values[1] - values[0] if len(values) > 1 else 1.0
