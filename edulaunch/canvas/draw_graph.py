"""Draw the node graph and the tf tree, with boxes and arrows at the positions of `layout`.

Nodes are ovals, topics are boxes, and services have a double border. A dashed box lacks a publisher, subscription or server.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.patches import FancyBboxPatch, PathPatch
from matplotlib.path import Path

from edulaunch.canvas import style
from edulaunch.canvas.graph_scene import LINE, FrameBox, GraphScene, TreeScene, label_lines
from edulaunch.canvas.graph_scene import Box as Item
from edulaunch.canvas.sheet import Box, Sheet, layout, polygon, rgb
from edulaunch.canvas.style import SMALL, TEXT, Colour, shortened

Point = tuple[float, float]
HEAD = 8.0
DASHED = (0, (4, 2.5))
LOOKS: dict[str, tuple[Colour, Colour, float]] = {
    'node': (style.BLUE_TINT, style.BLUE, 100.0),
    'topic': (style.SAND_TINT, style.SAND, 3.0),
    'service': (style.GREEN_TINT, style.GREEN, 3.0),
}
"""The fill colour, the edge colour, and the radius of the corners of each kind of box."""
LEGEND = 'oval: node   box: topic'
FRAME_LOOKS: dict[str, tuple[Colour, Colour]] = {
    'root': (style.PAPER, style.INK),
    'static': (style.GREEN_TINT, style.GREEN),
    'dynamic': (style.BLUE_TINT, style.BLUE),
}
"""The fill and edge colours of a frame's box, whose word gives the same information. The box of a static frame is dashed."""


def draw_box(
    ax: Axes, left: float, top: float, width: float, height: float, radius: float, fill: Colour | None, edge: Colour, **look: Any
) -> None:
    """Draw a box with rounded corners. With a large radius, the box is an oval."""
    corners = f'round,pad=0,rounding_size={min(radius, width / 2, height / 2)}'
    ground = 'none' if fill is None else rgb(fill)
    ax.add_patch(FancyBboxPatch((left, top), width, height, boxstyle=corners, facecolor=ground, edgecolor=rgb(edge), **look))


def write(ax: Axes, x: float, y: float, text: str, size: float, colour: Colour) -> None:
    """Write a ROS name or a remark about it, centred on (x, y)."""
    ax.text(x, y, text, fontsize=size, color=rgb(colour), family='DejaVu Sans Mono', ha='center', va='center_baseline')


def draw_route(ax: Axes, places: list[Point], direction: str, colour: Colour = style.MUTED, **look: Any) -> None:
    """Draw an arrow of alternating straight lines and S-curves, which ends in an arrowhead. As in layouts, y points down."""
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
    """Return the direction of the arrowhead, which is the direction of the layers or its opposite."""
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


def graph_sheet(scene: GraphScene) -> Sheet:
    """Return a sheet of the size of the graph, with space for the legend below."""
    width, height = _size(scene)
    return Sheet(width, height, [Box(0, 0, width, height)])


def _size(scene: GraphScene) -> tuple[float, float]:
    return max(scene.width, 340), scene.height + 18


def draw_graph(scene: GraphScene, axes: Sequence[Axes]) -> None:
    """Draw the arrows, the boxes over them, and the legend."""
    (ax,) = axes
    pixel = layout(ax, *_size(scene))
    for (start, end), route in zip(scene.arrows, scene.routes, strict=True):
        wrong = scene.boxes[start].mark or scene.boxes[end].mark
        draw_route(ax, route, scene.direction, style.RED if 'fit' in wrong else style.MUTED, linestyle=DASHED if wrong else '-')
    for box in scene.boxes:
        _draw_box(ax, box, pixel)
    more = '   double border: service' if any(box.kind == 'service' for box in scene.boxes) else ''
    more += '   dashed: an end is missing' if any(box.mark for box in scene.boxes) else ''
    ax.text(12, _size(scene)[1] - 8, LEGEND + more, fontsize=SMALL * pixel, color=rgb(style.MUTED))


def _draw_box(ax: Axes, box: Item, pixel: float) -> None:
    fill, edge, radius = LOOKS[box.kind]
    if box.mark:
        fill, edge = (style.RED_TINT, style.RED) if 'fit' in box.mark else (style.PAPER, style.MUTED)
    line = {'linewidth': 1.3, 'linestyle': DASHED if box.mark else '-'}
    draw_box(ax, box.left, box.top, box.width, box.height, radius, fill, edge, **line)
    if box.kind == 'service':
        draw_box(ax, box.left + 3, box.top + 3, box.width - 6, box.height - 6, 2, None, edge, linewidth=0.7)
    lines = label_lines(box.kind, box.name, box.mark)
    for number, (text, size, is_mark) in enumerate(lines):
        y = box.top + box.height / 2 + (number - (len(lines) - 1) / 2) * 13.5
        colour = style.RED if is_mark else style.INK if size > SMALL else style.MUTED
        write(ax, box.left + box.width / 2, y, text, size * pixel, colour)


def tree_sheet(scene: TreeScene) -> Sheet:
    """Return a sheet of the size of the tree."""
    return Sheet(scene.width, scene.height, [Box(0, 0, scene.width, scene.height)])


def draw_tree(scene: TreeScene, axes: Sequence[Axes]) -> None:
    """Draw the tf tree, with an arrow from each parent to its children."""
    (ax,) = axes
    pixel = layout(ax, scene.width, scene.height)
    for (_, child), route in zip(scene.links, scene.routes, strict=True):
        draw_route(ax, route, scene.direction, style.RED if scene.boxes[child].mark else style.MUTED)
    for box in scene.boxes:
        _draw_frame_box(ax, box, pixel)


def _draw_frame_box(ax: Axes, box: FrameBox, pixel: float) -> None:
    fill, edge = (style.RED_TINT, style.RED) if box.mark else FRAME_LOOKS[box.kind]
    line = DASHED if box.kind == 'static' else '-'
    draw_box(ax, box.left, box.top, box.width, box.height, 7, fill, edge, linewidth=1.3, linestyle=line)
    x, y = box.left + box.width / 2, box.top + LINE / 2 + 6
    write(ax, x, y, shortened(box.name), TEXT * pixel, style.INK)
    for number, line in enumerate([*box.lines, *([box.mark] if box.mark else [])], 1):
        write(ax, x, y + number * LINE, shortened(line), SMALL * pixel, style.RED if number > len(box.lines) else style.MUTED)


DRAWINGS: dict[type, tuple[Any, Any]] = {GraphScene: (graph_sheet, draw_graph), TreeScene: (tree_sheet, draw_tree)}
"""The function for the sheet of each kind of scene, and the function that draws the scene on that sheet's axes."""
