"""A run as a strip of small pictures, which replaces the replay where scripts do not run.

Notebooks store the strip, so its bytes must not depend on matplotlib's version. So the strip is an SVG that is created
without matplotlib.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from html import escape

from edulaunch.canvas.style import INK, LOOKS, MUTED, PAPER, SHELLS, Colour, robot, shade, turtle
from edulaunch.canvas.turtle_scene import Body, Window, turtle_scene
from edulaunch.canvas.worlds import World

GAP, LINE = 8, 16
NAME_LOOK = 'fill="#ffffff" stroke="#1f2933" stroke-width="2.5" paint-order="stroke"'
WINDOW_PX = 500
"""The size of a real turtlesim window in pixels, to which the widths of pens refer."""


def strip_times(duration_s: float, worlds: int) -> list[float]:
    """Return the times of the pictures: eight for one world, six for several worlds. The last time is the end of the run."""
    count = 8 if worlds == 1 else 6
    return [duration_s * number / (count - 1) for number in range(count)]


def filmstrip(worlds: list[World], duration_s: float) -> str:
    """Return an SVG. One world has two rows of four pictures; each of several worlds has a row of six pictures.

    :param worlds: the turtlesim windows of a run.
    :param duration_s: the simulated time of the last picture, in seconds since the start. The first picture is at 0.
    """
    times = strip_times(duration_s, len(worlds))
    columns, side = (4, 176) if len(worlds) == 1 else (6, 116)
    parts = []
    for number, time_s in enumerate(times):
        for place, window in enumerate(turtle_scene(worlds, time_s).windows):
            x, y = GAP + number % columns * (side + GAP), LINE + (number // columns + place) * (side + LINE + GAP)
            title = f'   {escape(window.title)}' if number == 0 and len(worlds) > 1 else ''
            parts.append(f'<text x="{x}" y="{y - 4}">t = {time_s:.1f} s{title}</text>')
            parts.append(f'<svg x="{x}" y="{y}" width="{side}" height="{side}" viewBox="0 0 {WINDOW_PX} {WINDOW_PX}">')
            parts += [*_window(window), '</svg>']
    width, height = columns * (side + GAP) + GAP, len(times) // columns * len(worlds) * (side + LINE + GAP)
    return _sheet(width, height, 'font-size="9.5"', '', parts)


def still(worlds: list[World], time_s: float) -> tuple[str, str]:
    """Return an SVG of all windows at one time, side by side with their names, and with a caption that describes them."""
    scene, side, parts = turtle_scene(worlds, time_s), 260, []
    for number, window in enumerate(scene.windows):
        x, y = GAP + number * (side + GAP), LINE
        left, right, _, top = window.limits
        scale = side / (right - left)
        parts.append(f'<text x="{x}" y="{y - 4}">{escape(window.title)}</text>')
        parts.append(f'<svg x="{x}" y="{y}" width="{side}" height="{side}" viewBox="0 0 {WINDOW_PX} {WINDOW_PX}">')
        parts += [*_window(window), '</svg>']
        for body in window.bodies:
            px, py = x + (body.x - left) * scale, y + (top - body.y) * scale - 18
            place = f'x="{px:.1f}" y="{py:.1f}" text-anchor="middle"'
            parts.append(f'<text {place} {NAME_LOOK}>{escape(body.name)}</text>')
    title = f'<title>{escape(scene.caption())}</title>'
    width, height = len(scene.windows) * (side + GAP) + GAP, side + LINE + GAP
    return _sheet(width, height, 'font-size="11" role="img"', title, parts), scene.caption()


def _sheet(width: int, height: int, more: str, title: str, parts: list[str]) -> str:
    """Return the whole SVG. It has a background, because its text must be readable on a dark page, too."""
    look = f'xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" fill="{_hex(MUTED)}"'
    paper = f'<rect width="{width}" height="{height}" fill="{_hex(PAPER)}"/>'
    return f'<svg {look} {more}>{title}{paper}{"".join(parts)}</svg>'


def _window(window: Window) -> Iterator[str]:
    left, right, _, top = window.limits
    scale = WINDOW_PX / (right - left)
    yield f'<rect width="{WINDOW_PX}" height="{WINDOW_PX}" fill="{_hex(window.background)}"/>'
    for trail in window.trails:
        points = _points(((x - left) * scale, (top - y) * scale) for x, y in trail.points)
        yield f'<polyline points="{points}" fill="none" stroke="{_hex(trail.colour)}" stroke-width="{max(trail.width, 3)}"/>'
    size = WINDOW_PX / (9.5 if window.kind == 'turtlesim' else 11.0)
    for body in window.bodies:
        yield from _body(body, window.kind, (body.x - left) * scale, (top - body.y) * scale, scale if body.outline else size)


def _body(body: Body, kind: str, x: float, y: float, size: float) -> Iterator[str]:
    c, s = math.cos(body.theta) * size, math.sin(body.theta) * size
    shell = SHELLS[body.number % len(SHELLS)]
    for part, corners in body.outline or (turtle() if kind == 'turtlesim' else robot()):
        points = _points((x + c * px - s * py, y - s * px - c * py) for px, py in corners)
        fill = {'shell': shell, 'nose': shell, 'plate': shade(shell), 'seam': shell}.get(part) or LOOKS[part]
        yield f'<polygon points="{points}" fill="{_hex(fill)}" stroke="{_hex(INK)}"/>'


def _points(places: Iterable[tuple[float, float]]) -> str:
    return ' '.join(f'{x + 0.0:.1f},{y + 0.0:.1f}' for x, y in places)


def _hex(colour: Colour) -> str:
    return '#{:02x}{:02x}{:02x}'.format(*colour)
