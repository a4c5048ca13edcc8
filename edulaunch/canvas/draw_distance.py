"""Distance over time as an image."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes

from edulaunch.canvas.distance_scene import DistanceScene
from edulaunch.canvas.labels import Box
from edulaunch.canvas.sheet import HALO, Sheet, rgb, world
from edulaunch.canvas.style import BLUE, GREEN, GREEN_TINT, GRID, MUTED, SMALL
from edulaunch.canvas.thinning import thinned

WIDTH, HEIGHT, LEFT, RIGHT, BELOW, ABOVE = 640, 260, 44, 18, 38, 30


def sheet(scene: DistanceScene) -> Sheet:
    """One wide diagram."""
    return Sheet(WIDTH, HEIGHT, [Box(LEFT, BELOW, WIDTH - RIGHT, HEIGHT - ABOVE)])


def draw(scene: DistanceScene, axes: Sequence[Axes]) -> None:
    """The distance as a line, the band that counts as close as a tinted ground with its border dashed."""
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
