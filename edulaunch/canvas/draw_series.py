"""Draw numbers of a topic, and the distance between two objects, over time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes

from edulaunch.canvas.series_scene import DistanceScene, SeriesScene, thinned
from edulaunch.canvas.sheet import HALO, Box, Sheet, rgb, world
from edulaunch.canvas.style import BLUE, GREEN, GREEN_TINT, GRID, MUTED, SMALL

WIDTH, HEIGHT, LEFT, RIGHT, BELOW, ABOVE = 640, 280, 52, 18, 38, 30
STYLES = ('-', '--', ':', '-.')
COLOURS = (BLUE, (196, 78, 10), GREEN, (140, 90, 180))
DISTANCE_HEIGHT, DISTANCE_LEFT = 260, 44


def series_sheet(scene: SeriesScene) -> Sheet:
    """Return a sheet with one wide diagram."""
    return Sheet(WIDTH, HEIGHT, [Box(LEFT, BELOW, WIDTH - RIGHT, HEIGHT - ABOVE)])


def draw_series(scene: SeriesScene, axes: Sequence[Axes]) -> None:
    """Draw a line for each field, distinguished by colour and dashes."""
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


def distance_sheet(scene: DistanceScene) -> Sheet:
    """Return a sheet with one wide diagram."""
    return Sheet(WIDTH, DISTANCE_HEIGHT, [Box(DISTANCE_LEFT, BELOW, WIDTH - RIGHT, DISTANCE_HEIGHT - ABOVE)])


def draw_distance(scene: DistanceScene, axes: Sequence[Axes]) -> None:
    """Draw the distance as a line, and the band that counts as close as a tinted area with a dashed border."""
    (ax,) = axes
    highest = max(*(distance for _, distance in scene.points), scene.close_m) * 1.1
    world(ax, (0.0, max(scene.duration_s, 1e-3), 0.0, max(highest, 1e-3)), grid=False, square=False)
    ax.grid(axis='y', color=rgb(GRID), linewidth=0.7)
    ax.axhspan(0, scene.close_m, facecolor=rgb(GREEN_TINT))
    ax.axhline(scene.close_m, color=rgb(GREEN), linewidth=1.2, linestyle='--')
    for stretch in _stretches(scene.points):
        ax.plot(*zip(*stretch, strict=True), color=rgb(BLUE), linewidth=1.8)
    since = '' if scene.close_since_s is None else f', for good from t = {scene.close_since_s:.2f} s on'
    text = f'close: below {scene.close_m:g} m{since}'
    ax.annotate(
        text,
        (1, scene.close_m),
        (-6, 5),
        xycoords=('axes fraction', 'data'),
        textcoords='offset points',
        ha='right',
        fontsize=SMALL,
        color=rgb(GREEN),
        path_effects=HALO,
    )
    if scene.close_since_s is not None:
        ax.plot(
            [scene.close_since_s] * 2,
            [0, scene.close_m],
            color=rgb(GREEN),
            linewidth=1.4,
            marker='o',
            markevery=[1],
            markersize=6,
        )
    ax.set_title(f'distance from {scene.first} to {scene.second} [m]', loc='left', y=1.0)
    ax.set_xlabel('time [s]', loc='right', fontsize=SMALL, color=rgb(MUTED), labelpad=1)


def _stretches(points: list[tuple[float, float]]) -> list[list[tuple[float, float]]]:
    cuts = [0, *(number for number in range(1, len(points)) if points[number][0] - points[number - 1][0] > 0.1), len(points)]
    return [thinned(points[start:end]) for start, end in zip(cuts, cuts[1:], strict=False) if end > start]


DRAWINGS: dict[type, tuple[Any, Any]] = {SeriesScene: (series_sheet, draw_series), DistanceScene: (distance_sheet, draw_distance)}
"""The function for the sheet of each kind of scene, and the function that draws the scene on that sheet's axes."""
