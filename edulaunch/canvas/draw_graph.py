"""The node graph as an image: nodes are ovals, topics are boxes, dashed where an end is missing."""
from __future__ import annotations

from typing import Any

from edulaunch.canvas.graph_scene import Box, GraphScene
from edulaunch.canvas.style import FONT, INK, new_figure, to_png

ROW_IN = 0.62
CHARACTER_IN = 0.078


def draw_graph(scene: GraphScene) -> bytes:
    """PNG bytes of the graph, as wide as its names need."""
    widths = _column_widths(scene)
    rows = max((sum(box.column == column for box in scene.boxes) for column in range(len(widths))), default=1)
    figure = new_figure(max(3.0, sum(widths) + 0.45 * len(widths) + 0.2), max(1.6, rows * ROW_IN + 0.5))
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    axes.set_xlim(0, figure.get_figwidth())
    axes.set_ylim(0, figure.get_figheight())
    places = [_place(box, widths, figure.get_figheight()) for box in scene.boxes]
    for start, end in scene.arrows:
        _draw_arrow(axes, places[start], _width(scene.boxes[start]), places[end], _width(scene.boxes[end]))
    for box, (x, y) in zip(scene.boxes, places, strict=True):
        _draw_box(axes, box, x, y)
    return to_png(figure)


def _label(box: Box) -> str:
    return f'{box.name}\n({box.mark})' if box.mark else box.name


def _width(box: Box) -> float:
    return max(map(len, _label(box).split('\n'))) * CHARACTER_IN + 0.3


def _column_widths(scene: GraphScene) -> list[float]:
    count = max((box.column for box in scene.boxes), default=0) + 1
    return [max((_width(box) for box in scene.boxes if box.column == column), default=0.5) for column in range(count)]


def _place(box: Box, widths: list[float], height: float) -> tuple[float, float]:
    left = 0.25 + sum(widths[:box.column]) + 0.45 * box.column
    return left + widths[box.column] / 2, height / 2 - box.row * ROW_IN


def _draw_box(axes: Any, box: Box, x: float, y: float) -> None:
    from matplotlib.patches import Ellipse, FancyBboxPatch
    width, height = _width(box), 0.4
    if box.kind == 'node':
        shape: Any = Ellipse((x, y), width, height, facecolor='#e8f0fe', edgecolor='#2b5fb3', linewidth=1.2, zorder=3)
    else:
        shape = FancyBboxPatch((x - width / 2 + 0.06, y - height / 2 + 0.06), width - 0.12, height - 0.12,
                               boxstyle='round,pad=0.04,rounding_size=0.03', facecolor='#ffffff' if box.mark else '#fff7e0',
                               edgecolor='#b3372b' if box.mark else '#8a6d1a', linewidth=1.2,
                               linestyle='--' if box.mark else '-', zorder=3)
    axes.add_patch(shape)
    axes.text(x, y, _label(box), ha='center', va='center', fontsize=8, family=FONT, color=INK, zorder=4)


def _draw_arrow(axes: Any, start: tuple[float, float], start_width: float, end: tuple[float, float], end_width: float) -> None:
    """A curve from the right side of one box to the left side of the other; back to the left it swings below."""
    from matplotlib.patches import FancyArrowPatch
    forward = end[0] > start[0]
    ends = ((start[0] + start_width / 2, start[1]), (end[0] - end_width / 2, end[1])) if forward else (
        (start[0], start[1] - 0.2), (end[0], end[1] - 0.2))
    bend = 'arc3,rad=0.0' if forward else 'arc3,rad=-0.25'
    axes.add_patch(FancyArrowPatch(*ends, arrowstyle='-|>', mutation_scale=9, linewidth=1.0, color='#5b6770',
                                   connectionstyle=bend, shrinkA=0, shrinkB=0, zorder=2))
