"""tf frames from above as an image: axes, names, and an arrow from each frame to its parent."""

from __future__ import annotations

import math

from edulaunch.canvas.frames_scene import FrameMark, FramesScene, View
from edulaunch.canvas.labels import Box, along, leader, place_labels
from edulaunch.canvas.panel import Panel
from edulaunch.canvas.paper import Paper
from edulaunch.canvas.style import INK, MUTED, PAPER, SMALL, TEXT, Colour, mono_width

ALONE, BESIDE, LEFT, BETWEEN, BELOW, ABOVE, TOP, LEGEND = 420, 340, 34, 22, 24, 24, 22, 20
AXIS = 30.0
X_COLOUR: Colour = (204, 36, 29)
Y_COLOUR: Colour = (46, 140, 48)


def draw_frames(scene: FramesScene) -> bytes:
    """PNG bytes: one panel per tree, at most two in a row, and the time above."""
    columns = min(2, len(scene.views))
    rows = math.ceil(len(scene.views) / columns)
    side = ALONE if columns == 1 else BESIDE
    cell_width, cell_height = LEFT + side + BETWEEN, ABOVE + side + BELOW
    paper = Paper(columns * cell_width, TOP + rows * cell_height + LEGEND)
    paper.text(LEFT, paper.height - 16, f't = {scene.time_s:.2f} s', colour=MUTED)
    for number, view in enumerate(scene.views):
        left = number % columns * cell_width + LEFT
        top = paper.height - TOP - number // columns * cell_height - ABOVE
        _draw_view(paper, view, Box(left, top - side, left + side, top))
    paper.text(LEFT, 10, 'thick: x axis   thin: y axis   arrow: to the parent frame (dashed: static)', size=SMALL, colour=MUTED)
    return paper.png()


def _draw_view(paper: Paper, view: View, box: Box) -> None:
    paper.text((box.left + box.right) / 2, box.top + 8, f'fixed frame: {view.root}', size=TEXT, font='mono', align='center')
    panel = Panel(paper, box, view.limits)
    panel.ground(PAPER, grid=True)
    places = {mark.name: panel.at(mark.x, mark.y) for mark in view.frames}
    for mark in view.frames:
        if mark.parent:
            _draw_parent(paper, places[mark.name], places[mark.parent], mark.is_static)
    for mark in view.frames:
        _draw_axes(paper, mark, *places[mark.name])
    _draw_names(panel, view.frames, places)
    panel.frame('m')


def _draw_parent(paper: Paper, start: tuple[float, float], end: tuple[float, float], is_static: bool) -> None:
    length = math.hypot(end[0] - start[0], end[1] - start[1])
    if length > 12:
        ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
        tip = (end[0] - 5 * ux, end[1] - 5 * uy)
        paper.line([start, (tip[0] - 6 * ux, tip[1] - 6 * uy)], colour=MUTED, width=1.3, dash=(4, 3) if is_static else ())
        paper.arrow_head(tip, (ux, uy), 8, colour=MUTED)


def _draw_axes(paper: Paper, mark: FrameMark, x: float, y: float) -> None:
    for (dx, dy), colour, letter, width in ((mark.y_axis, Y_COLOUR, 'y', 1.6), (mark.x_axis, X_COLOUR, 'x', 3.2)):
        paper.line([(x, y), (x + dx * AXIS, y + dy * AXIS)], colour=colour, width=width)
        paper.text(
            x + dx * (AXIS + 7),
            y + dy * (AXIS + 7),
            letter,
            size=SMALL - 1,
            font='bold',
            colour=colour,
            align='center',
            middle=True,
            halo=PAPER,
        )
    paper.disc(x, y, 2.6, fill=INK)


def _draw_names(panel: Panel, frames: list[FrameMark], places: dict[str, tuple[float, float]]) -> None:
    """Names clear of axes and of each other; a height above the ground is said in words."""
    texts = [mark.name + (f' (z={mark.z:.2f})' if abs(mark.z) >= 0.005 else '') for mark in frames]
    taken = [
        box
        for mark in frames
        for axis in (mark.x_axis, mark.y_axis)
        for box in along(places[mark.name], _axis_end(places[mark.name], axis))
    ]
    taken += [box for mark in frames if mark.parent for box in along(places[mark.name], places[mark.parent], 1.5)]
    anchors = [places[mark.name] for mark in frames]
    boxes = place_labels(anchors, [(mono_width(text) + 4, TEXT + 3) for text in texts], panel.box, 6, taken)
    for text, anchor, box in zip(texts, anchors, boxes, strict=True):
        end = leader(anchor, box)
        if end is not None:
            panel.paper.line([anchor, end], colour=INK, width=0.7, dash=(1.5, 2))
        panel.paper.text(
            (box.left + box.right) / 2, (box.bottom + box.top) / 2, text, font='mono', align='center', middle=True, halo=PAPER
        )


def _axis_end(place: tuple[float, float], axis: tuple[float, float]) -> tuple[float, float]:
    return (place[0] + axis[0] * (AXIS + 11), place[1] + axis[1] * (AXIS + 11))
