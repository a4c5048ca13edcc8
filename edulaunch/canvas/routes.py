"""Boxes and arrows of a drawing in layers, as `edulaunch.canvas.layout` places them."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.patches import FancyBboxPatch, PathPatch
from matplotlib.path import Path

from edulaunch.canvas.sheet import polygon, rgb
from edulaunch.canvas.style import MUTED, Colour

Point = tuple[float, float]
HEAD = 8.0
DASHED = (0, (4, 2.5))


def draw_box(
    ax: Axes, left: float, top: float, width: float, height: float, radius: float, fill: Colour | None, edge: Colour, **look: Any
) -> None:
    """A box with rounded corners, an oval with a large radius."""
    style = f'round,pad=0,rounding_size={min(radius, width / 2, height / 2)}'
    ground = 'none' if fill is None else rgb(fill)
    ax.add_patch(FancyBboxPatch((left, top), width, height, boxstyle=style, facecolor=ground, edgecolor=rgb(edge), **look))


def write(ax: Axes, x: float, y: float, text: str, size: float, colour: Colour) -> None:
    """A line of a ROS name or of what is said of it, in the middle of (x, y)."""
    ax.text(x, y, text, fontsize=size, color=rgb(colour), family='DejaVu Sans Mono', ha='center', va='center_baseline')


def draw_route(ax: Axes, places: list[Point], direction: str, colour: Colour = MUTED, **look: Any) -> None:
    """Straight stretches and S-curves in turn, ending in a head. Points have y down, as layouts have."""
    (x, y), (bx, by) = places[-1], places[-2]
    dx, dy = _direction(places, direction)
    path = [places[0]]
    for number, (start, end) in enumerate(zip(places, places[1:], strict=False)):
        path += _straight(start, end) if number % 2 == 0 else _bent(start, end, direction)
    path[-3:] = _straight((bx, by), (x - dx * (HEAD - 1), y - dy * (HEAD - 1)))
    curve = Path(path, [Path.MOVETO, *[Path.CURVE4] * (len(path) - 1)])
    ax.add_patch(PathPatch(curve, facecolor='none', edgecolor=rgb(colour), linewidth=1.3, **look))
    back, half = (x - dx * HEAD, y - dy * HEAD), HEAD * 0.42
    polygon(ax, [(x, y), (back[0] - dy * half, back[1] + dx * half), (back[0] + dy * half, back[1] - dx * half)], colour, None)


def _direction(points: list[Point], direction: str) -> Point:
    """Where the head looks: along the layers, or back."""
    forward = points[-1] > points[0] if direction == 'right' else points[-1][1] > points[0][1]
    sign = 1.0 if forward else -1.0
    return (sign, 0.0) if direction == 'right' else (0.0, sign)


def _straight(start: Point, end: Point) -> list[Point]:
    return [
        ((2 * start[0] + end[0]) / 3, (2 * start[1] + end[1]) / 3),
        ((start[0] + 2 * end[0]) / 3, (start[1] + 2 * end[1]) / 3),
        end,
    ]


def _bent(start: Point, end: Point, direction: str) -> list[Point]:
    if direction == 'right':
        middle = (start[0] + end[0]) / 2
        return [(middle, start[1]), (middle, end[1]), end]
    middle = (start[1] + end[1]) / 2
    return [(start[0], middle), (end[0], middle), end]
