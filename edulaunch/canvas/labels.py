"""Names beside points, so that none covers another while there is room."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple


class Box(NamedTuple):
    """A rectangle by its edges, in pixels."""

    left: float
    bottom: float
    right: float
    top: float

    def overlap(self, other: Box) -> float:
        """The area that both cover."""
        width = min(self.right, other.right) - max(self.left, other.left)
        height = min(self.top, other.top) - max(self.bottom, other.bottom)
        return width * height if width > 0 and height > 0 else 0.0

    def outside(self, bounds: Box) -> float:
        """The part of its area that lies outside of `bounds`."""
        return (self.right - self.left) * (self.top - self.bottom) - self.overlap(bounds)


COVERING = 300.0
"""What covering anything costs besides the area: more than the way to the furthest place."""
DIRECTIONS = ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, 1), (1, -1), (-1, -1))


def place_labels(
    anchors: Sequence[tuple[float, float]],
    sizes: Sequence[tuple[float, float]],
    bounds: Box,
    distance: float,
    taken: Iterable[Box] = (),
) -> list[Box]:
    """A box for each label: near its anchor, inside `bounds`, clear of the other labels and of what is `taken`.

    Labels are placed in order. A place that covers something is taken only where there is no free one inside.
    """
    placed = list(taken)
    first = len(placed)
    for (x, y), (width, height) in zip(anchors, sizes, strict=True):
        least, best = float('inf'), None
        for extra, box in _places(x, y, width, height, distance):
            if extra >= least:
                break  # all that follow are further away
            cost = extra + _cost(box, placed, bounds)
            if cost < least:
                least, best = cost, box
        assert best is not None
        placed.append(best)
    return placed[first:]


def _places(x: float, y: float, width: float, height: float, distance: float) -> list[tuple[float, Box]]:
    """Boxes around a point in rings of growing distance, as (what the distance costs, box)."""
    places: list[tuple[float, Box]] = []
    for ring in range(4):
        reach = distance + ring * (height / 2 + 1)
        for dx, dy in DIRECTIONS:
            left = x + dx * (reach + width / 2) - width / 2
            bottom = y + dy * (reach + height / 2) - height / 2
            places.append((ring * 3 * height, Box(left, bottom, left + width, bottom + height)))
    return places


def leader(anchor: tuple[float, float], box: Box) -> tuple[float, float] | None:
    """Where a line from the anchor to its label ends, if the label stands so far off that it needs one."""
    x, y = min(max(anchor[0], box.left), box.right), min(max(anchor[1], box.bottom), box.top)
    return (x, y) if (x - anchor[0]) ** 2 + (y - anchor[1]) ** 2 > 12**2 else None


def _cost(box: Box, placed: Sequence[Box], bounds: Box) -> float:
    covered = sum(box.overlap(other) for other in placed)
    return (COVERING + covered if covered else 0.0) + 4 * box.outside(bounds)


def along(start: tuple[float, float], end: tuple[float, float], half: float = 3.0) -> list[Box]:
    """Small boxes that together cover a line, so that labels keep clear of it."""
    steps = max(1, round(max(abs(end[0] - start[0]), abs(end[1] - start[1])) / (2 * half)))
    points = [
        (start[0] + (end[0] - start[0]) * step / steps, start[1] + (end[1] - start[1]) * step / steps)
        for step in range(steps + 1)
    ]
    return [Box(x - half, y - half, x + half, y + half) for x, y in points]
