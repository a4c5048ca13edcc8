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


DIRECTIONS = ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, 1), (1, -1), (-1, -1))


def place_labels(anchors: Sequence[tuple[float, float]], sizes: Sequence[tuple[float, float]], bounds: Box,
                 distance: float, taken: Iterable[Box] = ()) -> list[Box]:
    """A box for each label: near its anchor, inside `bounds`, clear of the other labels and of what is `taken`.

    Labels are placed in order; one for which no free place is found gets the place where it covers least.
    """
    placed = list(taken)
    first = len(placed)
    for (x, y), (width, height) in zip(anchors, sizes, strict=True):
        places = [_box(x + dx * (reach + width / 2), y + dy * (reach + height / 2), width, height)
                  for reach in (distance, distance + height + 2, distance + 2 * height + 4) for dx, dy in DIRECTIONS]
        placed.append(min(places, key=lambda box: sum(box.overlap(other) for other in placed) + 4 * box.outside(bounds)))
    return placed[first:]


def _box(x: float, y: float, width: float, height: float) -> Box:
    return Box(x - width / 2, y - height / 2, x + width / 2, y + height / 2)
