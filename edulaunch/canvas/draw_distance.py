"""Distance over time as an image."""

from __future__ import annotations

from edulaunch.canvas.distance_scene import DistanceScene
from edulaunch.canvas.labels import Box
from edulaunch.canvas.panel import Panel, ticks
from edulaunch.canvas.paper import Paper
from edulaunch.canvas.style import BLUE, GREEN, GREEN_TINT, MUTED, PAPER, SMALL, TEXT
from edulaunch.canvas.thinning import thinned

WIDTH, HEIGHT, LEFT, RIGHT, BELOW, ABOVE = 640, 260, 44, 18, 38, 30


def draw_distance(scene: DistanceScene) -> bytes:
    """PNG bytes: the distance as a line, the band that counts as close as a tinted ground with its border dashed."""
    paper = Paper(WIDTH, HEIGHT)
    highest = max(*(distance for _, distance in scene.points), scene.close_m) * 1.1
    panel = Panel(
        paper, Box(LEFT, BELOW, WIDTH - RIGHT, HEIGHT - ABOVE), (0.0, max(scene.duration_s, 1e-3), 0.0, max(highest, 1e-3))
    )
    panel.ground(PAPER, grid=False)
    _draw_band(panel, scene)
    for value in ticks(*panel.limits[2:])[1:]:
        paper.line(panel.points([(0, value), (panel.limits[1], value)]), colour=(226, 231, 236), width=0.7)
    for stretch in _stretches(scene.points):
        paper.line(panel.points(stretch), colour=BLUE, width=1.8)
    if scene.close_since_s is not None:
        x, y = panel.at(scene.close_since_s, 0)
        paper.line([(x, y), (x, panel.at(0, scene.close_m)[1])], colour=GREEN, width=1.4)
        paper.disc(x, panel.at(0, scene.close_m)[1], 3, fill=GREEN)
    panel.frame()
    paper.text(LEFT, HEIGHT - 18, f'distance from {scene.first} to {scene.second} [m]', size=TEXT)
    paper.text(WIDTH - RIGHT, 8, 'time [s]', size=SMALL, colour=MUTED, align='right')
    return paper.png()


def _draw_band(panel: Panel, scene: DistanceScene) -> None:
    left, right = panel.box.left, panel.box.right
    y = panel.at(0, scene.close_m)[1]
    panel.paper.box(left, panel.box.bottom, right - left, y - panel.box.bottom, fill=GREEN_TINT)
    panel.paper.line([(left, y), (right, y)], colour=GREEN, width=1.2, dash=(5, 3))
    since = '' if scene.close_since_s is None else f', for good from t = {scene.close_since_s:.2f} s on'
    panel.paper.text(
        right - 6, y + 5, f'close: below {scene.close_m:g} m{since}', size=SMALL, colour=GREEN, align='right', halo=PAPER
    )


def _stretches(points: list[tuple[float, float]]) -> list[list[tuple[float, float]]]:
    cuts = [0, *(number for number in range(1, len(points)) if points[number][0] - points[number - 1][0] > 0.1), len(points)]
    return [thinned(points[start:end]) for start, end in zip(cuts, cuts[1:], strict=False) if end > start]
