"""A run as a strip of small pictures: what stands in for the replay where scripts do not run."""

from __future__ import annotations

from edulaunch.canvas.draw_turtles import draw_window
from edulaunch.canvas.labels import Box
from edulaunch.canvas.panel import Panel
from edulaunch.canvas.paper import Paper
from edulaunch.canvas.style import MUTED, SMALL
from edulaunch.canvas.turtle_scene import turtle_scene
from edulaunch.canvas.worlds import World

GAP, LINE, SCALE = 8, 16, 1.5


def strip_times(duration_s: float, worlds: int) -> list[float]:
    """Eight times for one world, six for more; the last is the end."""
    count = 8 if worlds == 1 else 6
    return [duration_s * number / (count - 1) for number in range(count)]


def draw_filmstrip(worlds: list[World], duration_s: float) -> bytes:
    """PNG bytes: one world in two rows of four pictures; several worlds in a row of six each."""
    times = strip_times(duration_s, len(worlds))
    columns, side = (4, 176) if len(worlds) == 1 else (6, 116)
    rows = len(times) // columns * len(worlds)
    paper = Paper(columns * (side + GAP) + GAP, rows * (side + LINE + GAP) + LINE * (len(worlds) > 1), SCALE)
    for number, time_s in enumerate(times):
        for place, window in enumerate(turtle_scene(worlds, time_s).windows):
            row = number // columns + place
            left, top = GAP + number % columns * (side + GAP), paper.height - LINE - row * (side + LINE + GAP)
            text = f't = {time_s:.1f} s' + (f'   {window.title}' if number == 0 and len(worlds) > 1 else '')
            paper.text(left, top + 4, text, size=SMALL, colour=MUTED)
            draw_window(Panel(paper, Box(left, top - side, left + side, top), window.limits), window, names=False)
    return paper.png()
