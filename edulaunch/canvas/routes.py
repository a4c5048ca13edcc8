"""Ways of arrows, as `edulaunch.canvas.layout` finds them, drawn as lines with a head."""

from __future__ import annotations

from edulaunch.canvas.paper import Paper
from edulaunch.canvas.style import MUTED, Colour

Point = tuple[float, float]
HEAD = 8.0


def draw_route(paper: Paper, points: list[Point], direction: str, colour: Colour = MUTED, dash: tuple[float, ...] = ()) -> None:
    """Straight stretches and S-curves in turn, ending in a head. Points have y down, as layouts have."""
    places = [(x, paper.height - y) for x, y in points]
    (x, y), (bx, by) = places[-1], places[-2]
    flies = _direction(points, direction)
    neck = (x - flies[0] * (HEAD - 1), y - flies[1] * (HEAD - 1))
    path = [places[0]]
    for number, (start, end) in enumerate(zip(places, places[1:], strict=False)):
        path += _straight(start, end) if number % 2 == 0 else _bent(start, end, direction)
    path[-3:] = _straight((bx, by), neck)
    paper.curve(path, colour=colour, width=1.3, dash=dash)
    paper.arrow_head((x, y), flies, HEAD, colour=colour)


def _direction(points: list[Point], direction: str) -> Point:
    """Where the head looks: along the layers, or back."""
    forward = points[-1] > points[0] if direction == 'right' else points[-1][1] > points[0][1]
    sign = 1.0 if forward else -1.0
    return (sign, 0.0) if direction == 'right' else (0.0, -sign)


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
