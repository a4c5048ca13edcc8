"""Turtle windows as an image."""

from __future__ import annotations

import math

from edulaunch.canvas.glyphs import text_width
from edulaunch.canvas.labels import Box, place_labels
from edulaunch.canvas.panel import Panel
from edulaunch.canvas.paper import Paper
from edulaunch.canvas.shapes import LOOKS, SHELLS, Part, robot, shade, turtle
from edulaunch.canvas.style import INK, MUTED, PAPER, SMALL, TEXT
from edulaunch.canvas.turtle_scene import Body, TurtleScene, Window

SIDE, LEFT, BETWEEN, BELOW, ABOVE, TOP = 320, 30, 22, 24, 24, 22
TURTLESIM_PX = 500
"""Size of a real turtlesim window, in which widths of pens are meant."""


def draw_turtles(scene: TurtleScene) -> bytes:
    """PNG bytes: one panel per window, at most three in a row, and the time above."""
    columns = min(3, len(scene.windows))
    rows = math.ceil(len(scene.windows) / columns)
    cell_width, cell_height = LEFT + SIDE + BETWEEN, ABOVE + SIDE + BELOW
    paper = Paper(columns * cell_width, TOP + rows * cell_height)
    paper.text(LEFT, paper.height - 16, f't = {scene.time_s:.2f} s', colour=MUTED)
    for number, window in enumerate(scene.windows):
        left = number % columns * cell_width + LEFT
        top = paper.height - TOP - number // columns * cell_height - ABOVE
        paper.text(left + SIDE / 2, top + 8, window.title, size=TEXT, font='mono', align='center')
        panel = Panel(paper, Box(left, top - SIDE, left + SIDE, top), window.limits)
        draw_window(panel, window)
        panel.frame()
    return paper.png()


def draw_window(panel: Panel, window: Window, names: bool = True) -> None:
    """Ground, trails, bodies and, if wanted, their names."""
    paper, side = panel.paper, panel.box.right - panel.box.left
    panel.ground(window.background, grid=window.kind == 'robot')
    paper.clip(panel.box.left, panel.box.bottom, side, panel.box.top - panel.box.bottom)
    for trail in window.trails:
        paper.line(panel.points(trail.points), colour=trail.colour, width=max(1.0, trail.width * side / TURTLESIM_PX))
    size = side / (9.5 if window.kind == 'turtlesim' else 11.0)
    parts = turtle() if window.kind == 'turtlesim' else robot()
    for body in window.bodies:
        draw_body(panel, body, parts, size)
    paper.clip()
    if names:
        _draw_names(panel, window.bodies, size)


def draw_body(panel: Panel, body: Body, parts: list[Part], size: float) -> None:
    """A turtle or robot, `size` pixels long."""
    x, y = panel.at(body.x, body.y)
    c, s = math.cos(body.theta) * size, math.sin(body.theta) * size
    shell = SHELLS[body.number % len(SHELLS)]
    for kind, corners in parts:
        points = [(x + c * px - s * py, y + s * px + c * py) for px, py in corners]
        if kind == 'seam':
            panel.paper.line(points, colour=shade(shell, 0.5), width=0.8)
        else:
            fill = {'shell': shell, 'plate': shade(shell)}.get(kind) or LOOKS[kind]
            edge = shade(shell, 0.5) if kind == 'plate' else INK
            panel.paper.polygon(points, fill=fill, edge=edge, line_width=0.8)


def _draw_names(panel: Panel, bodies: list[Body], size: float) -> None:
    height = SMALL + 4
    anchors = [panel.at(body.x, body.y) for body in bodies]
    sizes = [(text_width(body.name, SMALL) + 6, height) for body in bodies]
    taken = [Box(x - size * 0.4, y - size * 0.4, x + size * 0.4, y + size * 0.4) for x, y in anchors]
    for body, box in zip(bodies, place_labels(anchors, sizes, panel.box, size * 0.62, taken), strict=True):
        panel.paper.box(box.left, box.bottom, box.right - box.left, height, radius=3, fill=PAPER, opacity=0.85)
        panel.paper.text(
            (box.left + box.right) / 2, (box.bottom + box.top) / 2, body.name, size=SMALL, align='center', middle=True
        )
