"""The tf tree as an image."""
from __future__ import annotations

from edulaunch.canvas.paper import Paper
from edulaunch.canvas.style import (
    BLUE, BLUE_TINT, GREEN, GREEN_TINT, INK, MUTED, PAPER, RED, RED_TINT, SMALL, Colour)
from edulaunch.canvas.tree_scene import LINE, FrameBox, TreeScene

LOOKS: dict[str, tuple[Colour, Colour, tuple[float, ...]]] = {
    'root': (PAPER, INK, ()), 'static': (GREEN_TINT, GREEN, (4, 2.5)), 'dynamic': (BLUE_TINT, BLUE, ())}
"""Fill, edge and dashes of a box; the word in it says the same."""


def draw_tree(scene: TreeScene) -> bytes:
    """PNG bytes: parents above children, an arrow from each parent to its children."""
    paper = Paper(scene.width, scene.height)
    for box in scene.boxes:
        if box.parent >= 0:
            _draw_link(paper, scene, scene.boxes[box.parent], box)
    for box in scene.boxes:
        _draw_box(paper, scene, box)
    return paper.png()


def _draw_link(paper: Paper, scene: TreeScene, parent: FrameBox, child: FrameBox) -> None:
    start = (parent.left + parent.width / 2, scene.height - parent.top - parent.height)
    end = (child.left + child.width / 2, scene.height - child.top)
    middle, neck = (start[1] + end[1]) / 2, end[1] + 7
    paper.curve([start, (start[0], middle), (end[0], middle + 8), (end[0], neck)], colour=MUTED, width=1.3)
    paper.arrow_head(end, (0, -1), 8, colour=MUTED)


def _draw_box(paper: Paper, scene: TreeScene, box: FrameBox) -> None:
    fill, edge, dash = (RED_TINT, RED, (4.0, 2.5)) if box.mark else LOOKS[box.kind]
    top = scene.height - box.top
    paper.box(box.left, top - box.height, box.width, box.height, radius=7, fill=fill, edge=edge, line_width=1.3, dash=dash)
    x, y = box.left + box.width / 2, top - LINE / 2 - 6
    paper.text(x, y, box.name, font='mono', align='center', middle=True)
    for number, line in enumerate(box.lines, 1):
        paper.text(x, y - number * LINE, line, size=SMALL, font='mono', colour=RED if line == box.mark else MUTED, align='center', middle=True)
