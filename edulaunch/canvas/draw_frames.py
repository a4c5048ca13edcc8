"""tf frames from above or from a side as an image: axes, names, and an arrow from each frame to its parent."""

from __future__ import annotations

import math
from collections.abc import Sequence

from matplotlib.axes import Axes

from edulaunch.canvas.frames_scene import FrameMark, FramesScene, View
from edulaunch.canvas.labels import along, leader, place_labels
from edulaunch.canvas.sheet import HALO, Sheet, box_of, points_of, rgb, rows_of, world
from edulaunch.canvas.style import INK, MUTED, SMALL, TEXT, Colour, mono_width

ALONE, BESIDE, LEFT, BETWEEN, BELOW, ABOVE = 420, 340, 34, 22, 40, 40
AXIS = 30.0
X_COLOUR: Colour = (204, 36, 29)
Y_COLOUR: Colour = (46, 140, 48)
Z_COLOUR: Colour = (38, 92, 178)
LEAST = 0.05
"""An axis that points towards who looks is not drawn."""
LEGEND = 'thick: x axis   thin: y axis   dotted: z axis   arrow: to the parent frame (dashed: static)   [m]'


def sheet(scene: FramesScene) -> Sheet:
    """One tree beside the other, at most two in a row."""
    count = len(scene.views)
    return rows_of(count, 2, ALONE if count == 1 else BESIDE, LEFT, BETWEEN, ABOVE, BELOW)


def draw(scene: FramesScene, axes: Sequence[Axes]) -> None:
    """Each tree in axes of its own, and the time above the first."""
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
    """The axes of a frame, those that can be seen."""
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
            ax.annotate(
                text,
                (mark.x, mark.y),
                (dx * reach, dy * reach),
                textcoords='offset points',
                ha='center',
                va='center',
                fontsize=SMALL - 1,
                weight='bold',
                color=rgb(colour),
                path_effects=HALO,
                arrowprops=line and {**line, 'shrinkA': 0, 'shrinkB': 0},
            )
    ax.plot([mark.x], [mark.y], 'o', color=rgb(INK), markersize=5)


def draw_names(ax: Axes, frames: list[FrameMark], pixels: dict[str, tuple[float, float]], side: str) -> None:
    """Names clear of axes and of each other; from above a height over the ground is said in words."""
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
        line = {'arrowstyle': '-', 'linestyle': ':', 'color': rgb(INK), 'linewidth': 0.7, 'shrinkB': 0}
        ax.annotate(
            text,
            (mark.x, mark.y),
            ((box.left + box.right) / 2 - x, (box.bottom + box.top) / 2 - y),
            textcoords='offset points',
            ha='center',
            va='center',
            fontsize=TEXT,
            family='DejaVu Sans Mono',
            path_effects=HALO,
            arrowprops=line if leader((x, y), box) is not None else None,
        )
