"""The tf tree as an image."""

from __future__ import annotations

from edulaunch.canvas.paper import Paper
from edulaunch.canvas.routes import draw_route
from edulaunch.canvas.style import BLUE, BLUE_TINT, GREEN, GREEN_TINT, INK, MUTED, PAPER, RED, RED_TINT, SMALL, Colour, shortened
from edulaunch.canvas.tree_scene import LINE, FrameBox, TreeScene

LOOKS: dict[str, tuple[Colour, Colour, tuple[float, ...]]] = {
    'root': (PAPER, INK, ()),
    'static': (GREEN_TINT, GREEN, (4, 2.5)),
    'dynamic': (BLUE_TINT, BLUE, ()),
}
"""Fill, edge and dashes of a box; the word in it says the same."""


def draw_tree(scene: TreeScene) -> bytes:
    """PNG bytes: an arrow from each parent to its children."""
    paper = Paper(scene.width, scene.height)
    for (_, child), route in zip(scene.links, scene.routes, strict=True):
        draw_route(paper, route, scene.direction, RED if scene.boxes[child].mark else MUTED)
    for box in scene.boxes:
        _draw_box(paper, box)
    return paper.png()


def _draw_box(paper: Paper, box: FrameBox) -> None:
    fill, edge, dash = (RED_TINT, RED, LOOKS[box.kind][2]) if box.mark else LOOKS[box.kind]
    top = paper.height - box.top
    paper.box(box.left, top - box.height, box.width, box.height, radius=7, fill=fill, edge=edge, line_width=1.3, dash=dash)
    x, y = box.left + box.width / 2, top - LINE / 2 - 6
    paper.text(x, y, shortened(box.name), font='mono', align='center', middle=True)
    for number, line in enumerate([*box.lines, *([box.mark] if box.mark else [])], 1):
        colour = RED if number > len(box.lines) else MUTED
        paper.text(x, y - number * LINE, shortened(line), size=SMALL, font='mono', colour=colour, align='center', middle=True)
