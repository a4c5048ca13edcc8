"""The tf tree as an image."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes

from edulaunch.canvas.labels import Box
from edulaunch.canvas.routes import DASHED, draw_box, draw_route, write
from edulaunch.canvas.sheet import Sheet, layout
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
    SMALL,
    TEXT,
    Colour,
    shortened,
)
from edulaunch.canvas.tree_scene import LINE, FrameBox, TreeScene

LOOKS: dict[str, tuple[Colour, Colour]] = {'root': (PAPER, INK), 'static': (GREEN_TINT, GREEN), 'dynamic': (BLUE_TINT, BLUE)}
"""Fill and edge of a box; the word in it says the same, and a static one is dashed."""


def sheet(scene: TreeScene) -> Sheet:
    """As large as the tree."""
    return Sheet(scene.width, scene.height, [Box(0, 0, scene.width, scene.height)])


def draw(scene: TreeScene, axes: Sequence[Axes]) -> None:
    """An arrow from each parent to its children."""
    (ax,) = axes
    pixel = layout(ax, scene.width, scene.height)
    for (_, child), route in zip(scene.links, scene.routes, strict=True):
        draw_route(ax, route, scene.direction, RED if scene.boxes[child].mark else MUTED)
    for box in scene.boxes:
        _draw_box(ax, box, pixel)


def _draw_box(ax: Axes, box: FrameBox, pixel: float) -> None:
    fill, edge = (RED_TINT, RED) if box.mark else LOOKS[box.kind]
    style = DASHED if box.kind == 'static' else '-'
    draw_box(ax, box.left, box.top, box.width, box.height, 7, fill, edge, linewidth=1.3, linestyle=style)
    x, y = box.left + box.width / 2, box.top + LINE / 2 + 6
    write(ax, x, y, shortened(box.name), TEXT * pixel, INK)
    for number, line in enumerate([*box.lines, *([box.mark] if box.mark else [])], 1):
        write(ax, x, y + number * LINE, shortened(line), SMALL * pixel, RED if number > len(box.lines) else MUTED)
