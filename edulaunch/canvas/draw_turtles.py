"""Turtle windows as an image."""
from __future__ import annotations

import math
from typing import Any

from edulaunch.canvas.style import FONT, GRID, INK, new_figure, to_png
from edulaunch.canvas.turtle_scene import Body, TurtleScene, Window

PANEL_IN = 3.6
SHELLS = ('#7fb069', '#e6aa68', '#ca3c25', '#a288a6', '#5bc0be', '#f4d35e')


def draw_turtles(scene: TurtleScene) -> bytes:
    """PNG bytes: one panel per window, at most three in a row."""
    columns = min(3, len(scene.windows))
    rows = math.ceil(len(scene.windows) / columns)
    figure = new_figure(PANEL_IN * columns, PANEL_IN * rows + 0.3)
    for number, window in enumerate(scene.windows, 1):
        axes = figure.add_subplot(rows, columns, number)
        _draw_window(axes, window)
    figure.suptitle(f't = {scene.time_s:.2f} s', fontsize=9, color=INK, family=FONT, y=0.985)
    figure.tight_layout(rect=(0, 0, 1, 0.97))
    return to_png(figure)


def _draw_window(axes: Any, window: Window) -> None:
    left, right, bottom, top = window.limits
    axes.set_facecolor([part / 255 for part in window.background])
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    axes.set_aspect('equal')
    axes.set_title(window.title, fontsize=9, color=INK, family=FONT)
    axes.tick_params(labelsize=7, colors=INK, length=2)
    if window.kind == 'robot':
        axes.grid(color=GRID, linewidth=0.6)
    for trail in window.trails:
        axes.plot([x for x, _ in trail.points], [y for _, y in trail.points], color=[part / 255 for part in trail.colour],
                  linewidth=trail.width * 0.55, solid_capstyle='round', zorder=2)
    size = (right - left) / (11.0 if window.kind == 'turtlesim' else 14.0)
    for number, body in enumerate(window.bodies):
        draw = _draw_turtle if window.kind == 'turtlesim' else _draw_robot
        draw(axes, body, size, SHELLS[number % len(SHELLS)])
        axes.annotate(body.name, (body.x, body.y), xytext=(0, 13), textcoords='offset points', ha='center', fontsize=7,
                      color=INK, family=FONT, zorder=6,
                      bbox={'boxstyle': 'round,pad=0.15', 'facecolor': 'white', 'edgecolor': 'none', 'alpha': 0.8})


def _placed(body: Body, size: float, points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Points of a shape that looks along +x, put where the body is."""
    c, s = math.cos(body.theta) * size, math.sin(body.theta) * size
    return [(body.x + c * x - s * y, body.y + s * x + c * y) for x, y in points]


def _oval(x: float, y: float, rx: float, ry: float, turn: float = 0.0) -> list[tuple[float, float]]:
    angles = [2 * math.pi * step / 24 for step in range(24)]
    c, s = math.cos(turn), math.sin(turn)
    return [(x + c * rx * math.cos(a) - s * ry * math.sin(a), y + s * rx * math.cos(a) + c * ry * math.sin(a)) for a in angles]


def _draw_turtle(axes: Any, body: Body, size: float, shell: str) -> None:
    skin = '#f2e8cf'
    parts = [(_oval(0.30, side * 0.34, 0.17, 0.09, side * 0.9), skin) for side in (1, -1)]
    parts += [(_oval(-0.27, side * 0.33, 0.14, 0.08, -side * 0.9), skin) for side in (1, -1)]
    parts += [([(-0.38, 0.06), (-0.58, 0.0), (-0.38, -0.06)], skin), (_oval(0.52, 0.0, 0.16, 0.13), skin)]
    parts += [(_oval(0.0, 0.0, 0.42, 0.36), shell), (_oval(0.0, 0.0, 0.22, 0.18), '#00000022')]
    parts += [(_oval(0.57, side * 0.06, 0.022, 0.022), INK) for side in (1, -1)]
    _fill(axes, body, size, parts)


def _draw_robot(axes: Any, body: Body, size: float, shell: str) -> None:
    parts = [([(-0.4, side * 0.36), (0.3, side * 0.36), (0.3, side * 0.48), (-0.4, side * 0.48)], INK) for side in (1, -1)]
    parts += [(_oval(0.0, 0.0, 0.45, 0.38), '#4c6a92'), ([(0.1, 0.18), (0.42, 0.0), (0.1, -0.18)], '#f4f7fb')]
    _fill(axes, body, size, parts)


def _fill(axes: Any, body: Body, size: float, parts: list[tuple[list[tuple[float, float]], str]]) -> None:
    from matplotlib.patches import Polygon
    for points, colour in parts:
        axes.add_patch(Polygon(_placed(body, size, points), closed=True, facecolor=colour, edgecolor=INK,
                               linewidth=0.6, zorder=4))
