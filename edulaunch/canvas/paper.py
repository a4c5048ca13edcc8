"""A sheet of pixels to draw on: a thin layer over matplotlib's Agg renderer, without figures and axes.

The origin is at the lower left, y goes up, the unit is one layout pixel. What was drawn later covers what was drawn before.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.path import Path
from matplotlib.transforms import Affine2D, Bbox

from edulaunch.canvas.glyphs import text_path, text_width
from edulaunch.canvas.png import encode
from edulaunch.canvas.style import INK, PAPER, SCALE, TEXT, Colour

Point = tuple[float, float]
ALIGN = {'left': 0.0, 'center': 0.5, 'right': 1.0}


class Paper:
    """A white sheet, `width` by `height` layout pixels; `scale` image pixels for each of them."""

    def __init__(self, width: float, height: float, scale: float = SCALE) -> None:
        self.width, self.height, self.scale = round(width), round(height), scale
        self._renderer: Any = _new_renderer(round(self.width * scale), round(self.height * scale))
        self._transform = Affine2D().scale(scale)
        self._clip: Any = None
        self.box(0, 0, self.width, self.height, fill=PAPER)

    def clip(self, x: float = 0, y: float = 0, width: float | None = None, height: float | None = None) -> None:
        """From now on draw only inside this box; without arguments, everywhere."""
        edges = (x, y, x + (width or 0), y + (height or 0))
        self._clip = None if width is None else Bbox.from_extents(*(edge * self.scale for edge in edges))

    def path(
        self,
        path: Path,
        fill: Colour | None = None,
        edge: Colour | None = None,
        line_width: float = 1.0,
        dash: Sequence[float] = (),
        opacity: float = 1.0,
    ) -> None:
        """Fill and stroke an outline. `dash`: lengths of strokes and gaps in pixels."""
        pen = self._renderer.new_gc()
        pen.set_linewidth(line_width * self.scale if edge is not None else 0.0)
        pen.set_foreground(_unit(edge or INK))
        pen.set_alpha(opacity)
        pen.set_capstyle('butt' if dash else 'round')
        pen.set_joinstyle('round')
        if dash:
            pen.set_dashes(0, [length * self.scale for length in dash])
        if self._clip is not None:
            pen.set_clip_rectangle(self._clip)
        self._renderer.draw_path(pen, path, self._transform, None if fill is None else _unit(fill))

    def polygon(self, points: Iterable[Point], **look: Any) -> None:
        """A closed shape; see :meth:`path` for its look."""
        corners = list(points)
        self.path(Path([*corners, corners[0]], closed=True), **look)

    def line(self, points: Sequence[Point] | Any, colour: Colour = INK, width: float = 1.0, **look: Any) -> None:
        """A line through points."""
        if len(points) > 1:
            self.path(Path(np.asarray(points, dtype=float)), edge=colour, line_width=width, **look)

    def curve(self, points: Sequence[Point], colour: Colour = INK, width: float = 1.0, **look: Any) -> None:
        """Joined cubic curves: a start, then two control points and an end for each."""
        self.path(Path(points, [Path.MOVETO, *[Path.CURVE4] * (len(points) - 1)]), edge=colour, line_width=width, **look)

    def box(self, x: float, y: float, width: float, height: float, radius: float = 0.0, **look: Any) -> None:
        """A rectangle by its lower left corner, with rounded corners."""
        right, top, r = x + width, y + height, min(radius, width / 2, height / 2)
        if r <= 0:
            self.polygon([(x, y), (right, y), (right, top), (x, top)], **look)
            return
        points = [
            (x + r, y),
            (right - r, y),
            (right, y),
            (right, y + r),
            (right, top - r),
            (right, top),
            (right - r, top),
            (x + r, top),
            (x, top),
            (x, top - r),
            (x, y + r),
            (x, y),
            (x + r, y),
            (x + r, y),
        ]
        codes = [Path.MOVETO, *[Path.LINETO, Path.CURVE3, Path.CURVE3] * 4, Path.CLOSEPOLY]
        self.path(Path(points, codes), **look)

    def disc(self, x: float, y: float, radius: float, **look: Any) -> None:
        """A circle."""
        self.path(Path.circle((x, y), radius), **look)

    def arrow_head(self, tip: Point, towards: Point, size: float = 7.0, colour: Colour = INK) -> None:
        """A filled head at `tip` that flies in direction `towards` (any length but 0)."""
        length = float(np.hypot(*towards)) or 1.0
        dx, dy = towards[0] / length * size, towards[1] / length * size
        back = (tip[0] - dx, tip[1] - dy)
        self.polygon([tip, (back[0] - dy * 0.42, back[1] + dx * 0.42), (back[0] + dy * 0.42, back[1] - dx * 0.42)], fill=colour)

    def text(
        self,
        x: float,
        y: float,
        text: str,
        size: float = TEXT,
        font: str = 'sans',
        colour: Colour = INK,
        align: str = 'left',
        middle: bool = False,
        halo: Colour | None = None,
    ) -> float:
        """A line of text with its baseline (with `middle`: half the height of its capitals) at y. Returns its width.

        :param font: 'sans', 'bold' or 'mono'.
        :param halo: colour of a seam around the letters that keeps them readable on any ground.
        """
        width = text_width(text, size, font)
        path = text_path(text, size, x - width * ALIGN[align], y - (0.365 * size if middle else 0.0), font)
        if path is not None:
            if halo is not None:
                self.path(path, edge=halo, line_width=2.6)
            self.path(path, fill=colour)
        return width

    def png(self) -> bytes:
        """The sheet as PNG, without a date or a version in it."""
        return encode(np.asarray(self._renderer.buffer_rgba()))


def _new_renderer(width: int, height: int) -> Any:
    make: Any = RendererAgg
    return make(width, height, 72)


def _unit(colour: Colour) -> tuple[float, float, float]:
    red, green, blue = colour
    return (red / 255, green / 255, blue / 255)
