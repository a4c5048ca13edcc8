"""Numbers over time as an image."""

from __future__ import annotations

import math
from collections.abc import Sequence

from matplotlib.axes import Axes

from edulaunch.canvas.labels import Box
from edulaunch.canvas.series_scene import SeriesScene
from edulaunch.canvas.sheet import Sheet, rgb, world
from edulaunch.canvas.style import BLUE, GREEN, GRID, MUTED, SMALL
from edulaunch.canvas.thinning import thinned

WIDTH, HEIGHT, LEFT, RIGHT, BELOW, ABOVE = 640, 280, 52, 18, 38, 30
STYLES = ('-', '--', ':', '-.')
COLOURS = (BLUE, (196, 78, 10), GREEN, (140, 90, 180))


def sheet(scene: SeriesScene) -> Sheet:
    """One wide diagram."""
    return Sheet(WIDTH, HEIGHT, [Box(LEFT, BELOW, WIDTH - RIGHT, HEIGHT - ABOVE)])


def draw(scene: SeriesScene, axes: Sequence[Axes]) -> None:
    """A line for each field, told apart by colour and dashes."""
    (ax,) = axes
    values = [value for _, points in scene.lines for _, value in points if math.isfinite(value)] or [0.0]
    low, high = min(values), max(values)
    margin = (high - low) * 0.06 or 0.5
    world(ax, (0.0, max(scene.duration_s, 1e-3), low - margin, high + margin), grid=False, square=False)
    ax.grid(color=rgb(GRID), linewidth=0.7)
    for number, (field, points) in enumerate(scene.lines):
        colour, style = rgb(COLOURS[number % len(COLOURS)]), STYLES[number // len(COLOURS) % len(STYLES)]
        finite = [point for point in points if math.isfinite(point[1])]
        ax.plot(*zip(*thinned(finite), strict=True), color=colour, linestyle=style, linewidth=1.6, label=field)
    ax.set_title(scene.topic, loc='left', y=1.0)
    ax.set_xlabel('time [s]', loc='right', fontsize=SMALL, color=rgb(MUTED), labelpad=1)
    ax.legend(fontsize=SMALL, frameon=False, loc='best')
