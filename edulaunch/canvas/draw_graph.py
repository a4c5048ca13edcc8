"""The node graph as an image: nodes are ovals, topics are boxes, services have a double border; dashed: an end is missing."""

from __future__ import annotations

from edulaunch.canvas.graph_scene import Box, GraphScene, label_lines
from edulaunch.canvas.paper import Paper
from edulaunch.canvas.routes import draw_route
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
DASHES = (4.0, 2.5)


def draw_graph(scene: GraphScene) -> bytes:
    """PNG bytes of the graph."""
    paper = Paper(max(scene.width, 340), scene.height + 18)
    for (start, end), route in zip(scene.arrows, scene.routes, strict=True):
        wrong = scene.boxes[start].mark or scene.boxes[end].mark
        draw_route(paper, route, scene.direction, RED if 'fit' in wrong else MUTED, DASHES if wrong else ())
    for box in scene.boxes:
        _draw_box(paper, box)
    more = '   double border: service' if any(box.kind == 'service' for box in scene.boxes) else ''
    more += '   dashed: an end is missing' if any(box.mark for box in scene.boxes) else ''
    paper.text(12, 8, LEGEND + more, size=SMALL, colour=MUTED)
    return paper.png()


def _draw_box(paper: Paper, box: Box) -> None:
    fill, edge, radius = LOOKS[box.kind]
    top = paper.height - box.top
    if box.mark:
        fill, edge = (RED_TINT, RED) if 'fit' in box.mark else (PAPER, MUTED)
    paper.box(
        box.left,
        top - box.height,
        box.width,
        box.height,
        radius=radius,
        fill=fill,
        edge=edge,
        line_width=1.3,
        dash=DASHES if box.mark else (),
    )
    if box.kind == 'service':
        paper.box(box.left + 3, top - box.height + 3, box.width - 6, box.height - 6, radius=2, edge=edge, line_width=0.7)
    lines = label_lines(box.kind, box.name, box.mark)
    for number, (text, size, is_mark) in enumerate(lines):
        y = top - box.height / 2 + ((len(lines) - 1) / 2 - number) * 13.5
        colour = RED if is_mark else INK if size > SMALL else MUTED
        paper.text(box.left + box.width / 2, y, text, size=size, font='mono', colour=colour, align='center', middle=True)
