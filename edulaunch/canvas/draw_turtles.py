"""Draw turtle windows, and tf frames from above or from a side. An arrow leads from each frame to its parent."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes

from edulaunch.canvas.frames_scene import FrameMark, FramesScene, View
from edulaunch.canvas.sheet import (
    HALO,
    Box,
    Sheet,
    along,
    box_of,
    leader,
    place_labels,
    points_of,
    polygon,
    rgb,
    rows_of,
    side_of,
    world,
)
from edulaunch.canvas.style import INK, LOOKS, MUTED, PAPER, SHELLS, SMALL, TEXT, Colour, Part, mono_width, robot, shade, turtle
from edulaunch.canvas.turtle_scene import Body, TurtleScene, Window

Point = tuple[float, float]
SIDE, LEFT, BETWEEN, BELOW, ABOVE = 320, 30, 22, 24, 40
DASHES = ('-', '--', '-.', ':')
"""Markers on coloured trails identify them without colour, too."""
TURTLESIM_PX = 500
"""The size of a real turtlesim window in pixels, to which the widths of pens refer."""
ALONE, BESIDE, VIEW_LEFT, VIEW_BELOW = 420, 340, 34, 40
AXIS = 30.0
X_COLOUR: Colour = (204, 36, 29)
Y_COLOUR: Colour = (46, 140, 48)
Z_COLOUR: Colour = (38, 92, 178)
LEAST = 0.05
"""The shortest projection of an axis that is drawn. An axis that points towards the viewer is shorter."""
LEGEND = 'thick: x axis   thin: y axis   dotted: z axis   arrow: to the parent frame (dashed: static)   [m]'


def turtles_sheet(scene: TurtleScene) -> Sheet:
    """Return a sheet with the windows side by side, at most three in a row."""
    return rows_of(len(scene.windows), 3, SIDE, LEFT, BETWEEN, ABOVE, BELOW)


def draw_turtles(scene: TurtleScene, axes: Sequence[Axes]) -> None:
    """Draw each window in separate axes, with the time above the first window."""
    for ax, window in zip(axes, scene.windows, strict=True):
        draw_window(ax, window)
        ax.set_title(window.title, family='DejaVu Sans Mono', y=1.0)
    axes[0].set_title(f't = {scene.time_s:.2f} s\n', loc='left', color=rgb(MUTED), y=1.0)


def draw_window(ax: Axes, window: Window, names: bool = True) -> None:
    """Draw the ground, the trails and the bodies, and the names of the bodies if requested."""
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
    """Draw a turtle or a robot. The coordinates of its parts are in units of `size` metres."""
    c, s = math.cos(body.theta) * size, math.sin(body.theta) * size
    shell = SHELLS[body.number % len(SHELLS)]
    for kind, corners in parts:
        points = [(body.x + c * px - s * py, body.y + s * px + c * py) for px, py in corners]
        fill = {'shell': shell, 'nose': shell, 'plate': shade(shell), 'seam': shade(shell, 0.5)}.get(kind) or LOOKS[kind]
        polygon(ax, points, fill, shade(shell, 0.5) if kind in ('plate', 'seam') else INK)


def _draw_names(ax: Axes, bodies: list[Body], size: float) -> None:
    """Write names beside the bodies, which are `size` layout pixels long."""
    anchors = points_of(ax, [(body.x, body.y) for body in bodies])
    sizes = [(mono_width(body.name, SMALL) + 6, SMALL + 4) for body in bodies]
    taken = [Box(x - size * 0.4, y - size * 0.4, x + size * 0.4, y + size * 0.4) for x, y in anchors]
    boxes = place_labels(anchors, sizes, box_of(ax), size * 0.62, taken)
    ground = {'boxstyle': 'round,pad=0.15', 'facecolor': rgb(PAPER), 'edgecolor': 'none', 'alpha': 0.85}
    for body, (x, y), box in zip(bodies, anchors, boxes, strict=True):
        away = ((box.left + box.right) / 2 - x, (box.bottom + box.top) / 2 - y)
        _write(ax, body.name, (body.x, body.y), away, SMALL, family='DejaVu Sans Mono', bbox=ground)


def _write(ax: Axes, text: str, place: Point, away: Point, size: float, **look: Any) -> None:
    """Write a label. Its centre is `away` layout pixels from a place in the world."""
    ax.annotate(text, place, away, textcoords='offset points', ha='center', va='center', fontsize=size, **look)


def frames_sheet(scene: FramesScene) -> Sheet:
    """Return a sheet with the trees side by side, at most two in a row."""
    count = len(scene.views)
    return rows_of(count, 2, ALONE if count == 1 else BESIDE, VIEW_LEFT, BETWEEN, ABOVE, VIEW_BELOW)


def draw_frames(scene: FramesScene, axes: Sequence[Axes]) -> None:
    """Draw each tree in separate axes, with the time above the first tree."""
    for ax, view in zip(axes, scene.views, strict=True):
        _draw_view(ax, view, scene.side)
    axes[0].set_title(f't = {scene.time_s:.2f} s\n', loc='left', color=rgb(MUTED), y=1.0)
    axes[-1].annotate(
        LEGEND, (0, 0), (0, -30), xycoords='axes fraction', textcoords='offset points', fontsize=SMALL - 1, color=rgb(MUTED)
    )


def _draw_view(ax: Axes, view: View, side: str) -> None:
    world(ax, view.limits, grid=True)
    seen = '' if side == 'xy' else f', {side[0]} and {side[1]}'
    ax.set_title(f'fixed frame: {view.root}{seen}', family='DejaVu Sans Mono', y=1.0)
    places = {mark.name: (mark.x, mark.y) for mark in view.frames}
    pixels = dict(zip(places, points_of(ax, list(places.values())), strict=True))
    for mark in view.frames:
        if mark.parent and math.dist(pixels[mark.name], pixels[mark.parent]) > 12:
            line = {'arrowstyle': '-|>', 'color': rgb(MUTED), 'linewidth': 1.3, 'shrinkA': 0, 'shrinkB': 5}
            style = {'linestyle': '--' if mark.is_static else '-', 'mutation_scale': 10}
            ax.annotate('', places[mark.parent], places[mark.name], arrowprops={**line, **style})
    for mark in view.frames:
        draw_axes(ax, mark)
    draw_names(ax, view.frames, pixels, side)


def draw_axes(ax: Axes, mark: FrameMark) -> None:
    """Draw the visible axes of a frame."""
    looks = (
        (mark.z_axis, Z_COLOUR, 'z', 1.6, ':'),
        (mark.y_axis, Y_COLOUR, 'y', 1.6, '-'),
        (mark.x_axis, X_COLOUR, 'x', 3.2, '-'),
    )
    for (dx, dy), colour, letter, width, style in looks:
        if math.hypot(dx, dy) < LEAST:
            continue
        for text, reach, line in (
            ('', AXIS, {'arrowstyle': '-', 'color': rgb(colour), 'linewidth': width, 'linestyle': style}),
            (letter, AXIS + 7, None),
        ):
            look = {'weight': 'bold', 'color': rgb(colour), 'path_effects': HALO}
            arrow = line and {**line, 'shrinkA': 0, 'shrinkB': 0}
            _write(ax, text, (mark.x, mark.y), (dx * reach, dy * reach), SMALL - 1, arrowprops=arrow, **look)
    ax.plot([mark.x], [mark.y], 'o', color=rgb(INK), markersize=5)


def draw_names(ax: Axes, frames: list[FrameMark], pixels: dict[str, tuple[float, float]], side: str) -> None:
    """Write names that cover neither axes nor each other. If seen from above, a label also gives the height above the ground."""
    texts = [mark.name + (f' (z={mark.z:.2f})' if side == 'xy' and abs(mark.z) >= 0.005 else '') for mark in frames]
    anchors = [pixels[mark.name] for mark in frames]
    reach = AXIS + 11
    ends = [
        (place, axis) for place, mark in zip(anchors, frames, strict=True) for axis in (mark.x_axis, mark.y_axis, mark.z_axis)
    ]
    taken = [box for (x, y), (dx, dy) in ends for box in along((x, y), (x + dx * reach, y + dy * reach))]
    taken += [box for mark in frames if mark.parent in pixels for box in along(pixels[mark.name], pixels[mark.parent], 1.5)]
    boxes = place_labels(anchors, [(mono_width(text) + 4, TEXT + 3) for text in texts], box_of(ax), 6, taken)
    for text, mark, (x, y), box in zip(texts, frames, anchors, boxes, strict=True):
        away = ((box.left + box.right) / 2 - x, (box.bottom + box.top) / 2 - y)
        line = {'arrowstyle': '-', 'linestyle': ':', 'color': rgb(INK), 'linewidth': 0.7, 'shrinkB': 0}
        arrow = line if leader((x, y), box) is not None else None
        _write(ax, text, (mark.x, mark.y), away, TEXT, family='DejaVu Sans Mono', path_effects=HALO, arrowprops=arrow)


DRAWINGS: dict[type, tuple[Any, Any]] = {TurtleScene: (turtles_sheet, draw_turtles), FramesScene: (frames_sheet, draw_frames)}
"""The function for the sheet of each kind of scene, and the function that draws the scene on that sheet's axes."""
