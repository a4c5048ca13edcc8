"""The node graph as an image: nodes are ovals, topics are boxes, services have a double border; dashed: an end is missing."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes

from edulaunch.canvas.graph_scene import Box as Item
from edulaunch.canvas.graph_scene import GraphScene, label_lines
from edulaunch.canvas.labels import Box
from edulaunch.canvas.routes import DASHED, draw_box, draw_route, write
from edulaunch.canvas.sheet import Sheet, layout, rgb
from edulaunch.canvas.style import (
    BLUE,
    BLUE_TINT,
    GREEN,
    GREEN_TINT,
    INK,
    MUTED,
    PAPER,
    RED,
    RED_TINT,
    SAND,
    SAND_TINT,
    SMALL,
    Colour,
)

LOOKS: dict[str, tuple[Colour, Colour, float]] = {
    'node': (BLUE_TINT, BLUE, 100.0),
    'topic': (SAND_TINT, SAND, 3.0),
    'service': (GREEN_TINT, GREEN, 3.0),
}
"""Fill, edge, and radius of the corners."""
LEGEND = 'oval: node   box: topic'


def sheet(scene: GraphScene) -> Sheet:
    """As large as the graph, with the legend below."""
    width, height = _size(scene)
    return Sheet(width, height, [Box(0, 0, width, height)])


def _size(scene: GraphScene) -> tuple[float, float]:
    return max(scene.width, 340), scene.height + 18


def draw(scene: GraphScene, axes: Sequence[Axes]) -> None:
    """Arrows, boxes over them, and the legend."""
    (ax,) = axes
    pixel = layout(ax, *_size(scene))
    for (start, end), route in zip(scene.arrows, scene.routes, strict=True):
        wrong = scene.boxes[start].mark or scene.boxes[end].mark
        draw_route(ax, route, scene.direction, RED if 'fit' in wrong else MUTED, linestyle=DASHED if wrong else '-')
    for box in scene.boxes:
        _draw_box(ax, box, pixel)
    more = '   double border: service' if any(box.kind == 'service' for box in scene.boxes) else ''
    more += '   dashed: an end is missing' if any(box.mark for box in scene.boxes) else ''
    ax.text(12, _size(scene)[1] - 8, LEGEND + more, fontsize=SMALL * pixel, color=rgb(MUTED))


def _draw_box(ax: Axes, box: Item, pixel: float) -> None:
    fill, edge, radius = LOOKS[box.kind]
    if box.mark:
        fill, edge = (RED_TINT, RED) if 'fit' in box.mark else (PAPER, MUTED)
    line = {'linewidth': 1.3, 'linestyle': DASHED if box.mark else '-'}
    draw_box(ax, box.left, box.top, box.width, box.height, radius, fill, edge, **line)
    if box.kind == 'service':
        draw_box(ax, box.left + 3, box.top + 3, box.width - 6, box.height - 6, 2, None, edge, linewidth=0.7)
    lines = label_lines(box.kind, box.name, box.mark)
    for number, (text, size, is_mark) in enumerate(lines):
        y = box.top + box.height / 2 + (number - (len(lines) - 1) / 2) * 13.5
        colour = RED if is_mark else INK if size > SMALL else MUTED
        write(ax, box.left + box.width / 2, y, text, size * pixel, colour)
