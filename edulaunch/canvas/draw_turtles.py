"""Turtle windows as an image."""

from __future__ import annotations

import math
from collections.abc import Sequence

from matplotlib.axes import Axes

from edulaunch.canvas.draw_frames import draw_axes, draw_names
from edulaunch.canvas.labels import Box, place_labels
from edulaunch.canvas.shapes import LOOKS, SHELLS, Part, robot, shade, turtle
from edulaunch.canvas.sheet import Sheet, box_of, points_of, polygon, rgb, rows_of, side_of, world
from edulaunch.canvas.style import INK, MUTED, PAPER, SMALL, mono_width
from edulaunch.canvas.turtle_scene import Body, TurtleScene, Window

SIDE, LEFT, BETWEEN, BELOW, ABOVE = 320, 30, 22, 24, 40
DASHES = ('-', '--', '-.', ':')
"""Of trails that have a colour of their own: whose they are must be seen without it, too."""
TURTLESIM_PX = 500
"""Size of a real turtlesim window, in which widths of pens are meant."""


def sheet(scene: TurtleScene) -> Sheet:
    """One window beside the other, at most three in a row."""
    return rows_of(len(scene.windows), 3, SIDE, LEFT, BETWEEN, ABOVE, BELOW)


def draw(scene: TurtleScene, axes: Sequence[Axes]) -> None:
    """Each window in axes of its own, and the time above the first."""
    for ax, window in zip(axes, scene.windows, strict=True):
        draw_window(ax, window)
        ax.set_title(window.title, family='DejaVu Sans Mono', y=1.0)
    axes[0].set_title(f't = {scene.time_s:.2f} s\n', loc='left', color=rgb(MUTED), y=1.0)


def draw_window(ax: Axes, window: Window, names: bool = True) -> None:
    """Ground, trails, bodies and, if wanted, their names."""
    world(ax, window.limits, window.background, grid=window.kind == 'robot')
    pixel = side_of(ax) / TURTLESIM_PX
    for trail in window.trails:
        xs, ys = zip(*trail.points, strict=True)
        style = DASHES[SHELLS.index(trail.colour) % len(DASHES)] if trail.colour in SHELLS else '-'
        ax.plot(xs, ys, style, color=rgb(trail.colour), linewidth=max(1.0, trail.width * pixel))
    size = (window.limits[1] - window.limits[0]) / (9.5 if window.kind == 'turtlesim' else 11.0)
    parts = turtle() if window.kind == 'turtlesim' else robot()
    for body in window.bodies:
        _draw_body(ax, body, body.outline or parts, 1.0 if body.outline else size)
    if window.frames:
        for mark in window.frames:
            draw_axes(ax, mark)
        places = points_of(ax, [(mark.x, mark.y) for mark in window.frames])
        own = {body.name for body in window.bodies}
        strange = [mark for mark in window.frames if mark.name not in own]
        draw_names(ax, strange, dict(zip((mark.name for mark in window.frames), places, strict=True)), 'xy')
    if names and window.bodies:
        _draw_names(ax, window.bodies, size / (window.limits[1] - window.limits[0]) * side_of(ax))


def _draw_body(ax: Axes, body: Body, parts: Sequence[Part], size: float) -> None:
    """A turtle or robot; its parts are in units of `size` metres."""
    c, s = math.cos(body.theta) * size, math.sin(body.theta) * size
    shell = SHELLS[body.number % len(SHELLS)]
    for kind, corners in parts:
        points = [(body.x + c * px - s * py, body.y + s * px + c * py) for px, py in corners]
        fill = {'shell': shell, 'nose': shell, 'plate': shade(shell), 'seam': shade(shell, 0.5)}.get(kind) or LOOKS[kind]
        polygon(ax, points, fill, shade(shell, 0.5) if kind in ('plate', 'seam') else INK)


def _draw_names(ax: Axes, bodies: list[Body], size: float) -> None:
    """Names beside the bodies, which are `size` layout pixels long."""
    anchors = points_of(ax, [(body.x, body.y) for body in bodies])
    sizes = [(mono_width(body.name, SMALL) + 6, SMALL + 4) for body in bodies]
    taken = [Box(x - size * 0.4, y - size * 0.4, x + size * 0.4, y + size * 0.4) for x, y in anchors]
    boxes = place_labels(anchors, sizes, box_of(ax), size * 0.62, taken)
    ground = {'boxstyle': 'round,pad=0.15', 'facecolor': rgb(PAPER), 'edgecolor': 'none', 'alpha': 0.85}
    for body, (x, y), box in zip(bodies, anchors, boxes, strict=True):
        away = ((box.left + box.right) / 2 - x, (box.bottom + box.top) / 2 - y)
        ax.annotate(
            body.name,
            (body.x, body.y),
            away,
            textcoords='offset points',
            ha='center',
            va='center',
            fontsize=SMALL,
            family='DejaVu Sans Mono',
            bbox=ground,
        )
