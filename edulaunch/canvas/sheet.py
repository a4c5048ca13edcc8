"""Figures and axes of matplotlib for all pictures: the places of axes, their style, the PNG, and labels that do not overlap.

A layout pixel is a point (1/72 inch), so the sizes of fonts and lines are in layout pixels, too.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from typing import Any, NamedTuple

import matplotlib.style
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator

from edulaunch.canvas.style import GRID, INK, MUTED, PAPER, SCALE, SMALL, TEXT, Colour

COVERING = 300.0
"""The additional cost of covering something, which is higher than the cost of the furthest position."""
DIRECTIONS = ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, 1), (1, -1), (-1, -1))
PER_INCH = 72
HALO = [withStroke(linewidth=2.6, foreground='white')]
"""An outline around letters that keeps them readable on any background."""
STYLE: dict[str, Any] = {
    'font.family': 'DejaVu Sans',
    'font.size': SMALL,
    'axes.titlesize': TEXT,
    'axes.linewidth': 0.8,
    'axes.axisbelow': True,
    'text.parse_math': False,
    'lines.solid_capstyle': 'round',
}


class Box(NamedTuple):
    """A rectangle by its edges, in pixels."""

    left: float
    bottom: float
    right: float
    top: float

    def overlap(self, other: Box) -> float:
        """Return the area of the intersection with another box, in square pixels."""
        width = min(self.right, other.right) - max(self.left, other.left)
        height = min(self.top, other.top) - max(self.bottom, other.bottom)
        return width * height if width > 0 and height > 0 else 0.0

    def outside(self, bounds: Box) -> float:
        """Return the area of the part of this box that is outside `bounds`, in square pixels."""
        return (self.right - self.left) * (self.top - self.bottom) - self.overlap(bounds)


def place_labels(
    anchors: Sequence[tuple[float, float]],
    sizes: Sequence[tuple[float, float]],
    bounds: Box,
    distance: float,
    taken: Iterable[Box] = (),
) -> list[Box]:
    """Return a box for each label: near its anchor, inside `bounds`, without covering other labels or `taken`.

    Labels are placed in order. A position that covers something is used only if there is no free position inside `bounds`.
    """
    placed = list(taken)
    first = len(placed)
    for (x, y), (width, height) in zip(anchors, sizes, strict=True):
        least, best = float('inf'), None
        for extra, box in _places(x, y, width, height, distance):
            if extra >= least:
                break  # all other places are further away
            cost = extra + _cost(box, placed, bounds)
            if cost < least:
                least, best = cost, box
        assert best is not None
        placed.append(best)
    return placed[first:]


def _places(x: float, y: float, width: float, height: float, distance: float) -> list[tuple[float, Box]]:
    """Return boxes around a point in rings of increasing distance, as (cost of the distance, box)."""
    places: list[tuple[float, Box]] = []
    for ring in range(4):
        reach = distance + ring * (height / 2 + 1)
        for dx, dy in DIRECTIONS:
            left = x + dx * (reach + width / 2) - width / 2
            bottom = y + dy * (reach + height / 2) - height / 2
            places.append((ring * 3 * height, Box(left, bottom, left + width, bottom + height)))
    return places


def leader(anchor: tuple[float, float], box: Box) -> tuple[float, float] | None:
    """Return the end of a line from the anchor to its label, or None if the label is near enough without a line."""
    x, y = min(max(anchor[0], box.left), box.right), min(max(anchor[1], box.bottom), box.top)
    return (x, y) if (x - anchor[0]) ** 2 + (y - anchor[1]) ** 2 > 12**2 else None


def _cost(box: Box, placed: Sequence[Box], bounds: Box) -> float:
    covered = sum(box.overlap(other) for other in placed)
    return (COVERING + covered if covered else 0.0) + 4 * box.outside(bounds)


def along(start: tuple[float, float], end: tuple[float, float], half: float = 3.0) -> list[Box]:
    """Return small boxes that together cover a line, so that labels avoid it.

    :param start: the first end of the line, in pixels.
    :param end: the second end of the line, in pixels.
    :param half: half of the width and height of each box, in pixels.
    """
    steps = max(1, round(max(abs(end[0] - start[0]), abs(end[1] - start[1])) / (2 * half)))
    points = [
        (start[0] + (end[0] - start[0]) * step / steps, start[1] + (end[1] - start[1]) * step / steps)
        for step in range(steps + 1)
    ]
    return [Box(x - half, y - half, x + half, y + half) for x, y in points]


class Sheet(NamedTuple):
    """The size of a picture and the box of each of its axes, in layout pixels with y up."""

    width: float
    height: float
    boxes: list[Box]


def rows_of(count: int, most: int, side: float, left: float, between: float, above: float, below: float) -> Sheet:
    """Return a sheet with squares for axes, in rows from the upper left. All sizes are in layout pixels.

    :param count: the number of squares, at least 1.
    :param most: the maximum number of squares in a row.
    :param side: the side of a square.
    :param left: the free space on the left of each square.
    :param between: the free space on the right of each square.
    :param above: the free space above each square.
    :param below: the free space below each square.
    """
    columns = min(most, count)
    rows = math.ceil(count / columns)
    width, height = left + side + between, above + side + below
    corners = [(number % columns * width + left, (rows - number // columns) * height - above) for number in range(count)]
    return Sheet(columns * width, rows * height, [Box(x, y - side, x + side, y) for x, y in corners])


def png_of(sheet: Sheet, draw: Callable[[Sequence[Axes]], None], scale: float = SCALE) -> bytes:
    """Return the picture as PNG, without date and version. The bytes then depend only on matplotlib's version.

    :param scale: the number of image pixels for each layout pixel.
    """
    with our_style():
        figure = Figure(figsize=(sheet.width / PER_INCH, sheet.height / PER_INCH), dpi=PER_INCH * scale)
        draw([figure.add_axes(_part(box, sheet)) for box in sheet.boxes])
        file = BytesIO()
        figure.savefig(file, format='png', metadata={'Software': None}, pil_kwargs={'compress_level': 1})
    return file.getvalue()


def _part(box: Box, sheet: Sheet) -> tuple[float, float, float, float]:
    return (
        box.left / sheet.width,
        box.bottom / sheet.height,
        (box.right - box.left) / sheet.width,
        (box.top - box.bottom) / sheet.height,
    )


@contextmanager
def our_style() -> Iterator[None]:
    """Use matplotlib's default style with the sizes of this package, and ignore the user's settings. Draw a box for a missing
    letter without a warning.
    """
    with matplotlib.style.context(['default', STYLE]), warnings.catch_warnings():
        warnings.filterwarnings('ignore', message='Glyph .* missing from', category=UserWarning)
        yield


def side_of(ax: Axes) -> float:
    """Return the width of the axes in layout pixels."""
    return float(ax.get_window_extent().width * PER_INCH / _dpi(ax))


def points_of(ax: Axes, places: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Convert points of the axes' world to layout pixels on the sheet."""
    return [(float(x), float(y)) for x, y in ax.transData.transform(list(places)) * PER_INCH / _dpi(ax)]


def box_of(ax: Axes) -> Box:
    """Return the box of the axes on the sheet, in layout pixels."""
    extent = ax.get_window_extent()
    return Box(*(float(edge * PER_INCH / _dpi(ax)) for edge in (extent.x0, extent.y0, extent.x1, extent.y1)))


def _dpi(ax: Axes) -> float:
    return float(ax.get_figure(root=True).dpi)  # type: ignore[union-attr]


def rgb(colour: Colour) -> tuple[float, float, float]:
    """Return a colour in the form of matplotlib."""
    red, green, blue = colour
    return (red / 255, green / 255, blue / 255)


def world(
    ax: Axes, limits: tuple[float, float, float, float], ground: Colour = PAPER, *, grid: bool, square: bool = True
) -> None:
    """Make the axes show an area of the world, with ticks and a background.

    :param limits: (left, right, bottom, top) of the area, in metres.
    :param ground: the colour of the background.
    :param square: whether a metre has the same length in both directions.
    """
    ax.set_xlim(limits[0], limits[1])
    ax.set_ylim(limits[2], limits[3])
    ax.set_facecolor(rgb(ground))
    if square:
        ax.set_aspect('equal')
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_locator(MaxNLocator(7, steps=[1, 2, 5, 10]))
    ax.tick_params(length=3, width=0.8, color=rgb(MUTED), labelsize=SMALL - 0.5)
    for spine in ax.spines.values():
        spine.set_color(rgb(MUTED))
    if grid:
        ax.grid(color=rgb(GRID), linewidth=0.8)


def layout(ax: Axes, width: float, height: float) -> float:
    """Make the axes show a drawing in pixels with y down. Return the size of one of these pixels in layout pixels."""
    ax.set_xlim(0, width)
    ax.set_ylim(height, 0)
    ax.set_aspect('equal')
    ax.axis('off')
    return side_of(ax) / width


def polygon(ax: Axes, corners: Sequence[tuple[float, float]], fill: Colour, edge: Colour | None = INK) -> None:
    """Draw a filled shape over lines."""
    border = 'none' if edge is None else rgb(edge)
    ax.add_patch(Polygon(list(corners), closed=True, facecolor=rgb(fill), edgecolor=border, linewidth=0.8, zorder=3))
