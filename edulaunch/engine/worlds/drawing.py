"""The drawing layer of a turtle window: the lines of the pens, computed with turtlesim's single precision."""

from __future__ import annotations

from math import copysign, inf, nan
from struct import Struct

_single = Struct('f')
_pack = _single.pack
_unpack = _single.unpack


def as_float32(value: float) -> float:
    """Round `value` to the nearest 32-bit float, as a C `float` does. A number that is too large becomes infinite."""
    try:
        rounded: float = _unpack(_pack(value))[0]
    except OverflowError:
        return copysign(inf, value)
    return rounded


SIDE_PX = 500
METRE_PX = 45.0
SIDE = as_float32((SIDE_PX - 1) / METRE_PX)
_ROW = 3 * SIDE_PX
_MARGIN = 256  # makes numbers positive, so that int() rounds down when a broad pen crosses the left or upper edge

Color = tuple[int, int, int]  # red, green, blue, 0 to 255

UNTOUCHED: Color = (255, 255, 255)


class Pen:
    """The pen of a turtle: colour, width in pixels, and whether it touches the canvas.

    :ivar last_x: the x coordinate of the end of the last line in pixels, or nan.
    :ivar last_y: the y coordinate of the end of the last line in pixels, or nan.
    :ivar column: the left column of the last square, counted from the margin.
    :ivar row: the top row of the last square, counted from the margin.
    """

    __slots__ = (
        'color',
        'width',
        'on',
        'stroke',
        'length',
        'reach',
        'reach_rows',
        'edge',
        'shift',
        'last_x',
        'last_y',
        'column',
        'row',
    )

    def __init__(self, color: Color = (179, 184, 255), width: int = 3, on: bool = True) -> None:
        self.color = color
        self.width = width or 1  # a pen of width 0 is drawn one pixel wide
        self.on = on
        self.stroke = bytes(color) * self.width
        self.length = 3 * self.width  # length of the stroke, in bytes
        self.reach = 0.5 * self.width  # distance between squares, in pixels
        self.reach_rows = self.width * _ROW  # distance from a square's first row to the row below the square, in bytes
        self.edge = SIDE_PX - self.width  # last column and row where a square can begin without crossing the edge
        self.shift = _MARGIN + 1.0 - self.width / 2.0  # offset from a position to the first pixel of its square, in pixels
        self.column = self.row = 0
        self.lift()

    def lift(self) -> None:
        """Forget the end of the last line, because its pixels have been deleted."""
        self.last_x = self.last_y = nan


class DrawingLayer:
    """A layer of 500 x 500 pixels over the background.

    A pixel that no pen has touched is white, whatever the background. A line consists of squares of the pen's width, close to
    each other. The pixels are created with the first line. `version` increases with every change, so that a resting turtle
    does not need to read its colour again.
    """

    __slots__ = ('version', '_pixels', '_newest')

    def __init__(self) -> None:
        self.version = 0
        self._pixels: bytearray | None = None
        self._newest: Pen | None = None  # the pen that drew the last square

    def clear(self) -> None:
        """Delete every line. Turtles that continue to draw must lift their pens."""
        self.version += 1
        self._pixels = None
        self._newest = None

    def trace(self, pen: Pen, x0: float, y0: float, x1: float, y1: float) -> Color:
        """Draw a line with a pen. Return the colour that the end of the line had before.

        A slow turtle stays on one pixel for many ticks. If the square to draw equals the last square, the drawing does not
        change, and the colour is the pen's colour. (This makes the large project 15 % faster.)

        :param x0: x coordinate of the start, in metres from the left edge of the canvas.
        :param y0: y coordinate of the start, in metres from the upper edge; y points down.
        :param x1: x coordinate of the end, in metres from the left edge of the canvas.
        :param y1: y coordinate of the end, in metres from the upper edge; y points down.
        """
        if pen is self._newest and x0 * METRE_PX == pen.last_x and y0 * METRE_PX == pen.last_y:
            x = x1 * METRE_PX
            y = y1 * METRE_PX
            if 0.0 <= x + pen.shift - pen.column < 1.0 and 0.0 <= y + pen.shift - pen.row < 1.0:
                pen.last_x = x
                pen.last_y = y
                return pen.color
        color = self.color_at(x1, y1)
        self.draw(pen, x0, y0, x1, y1)
        return color

    def color_at(self, x: float, y: float) -> Color:
        """Return the colour of the nearest pixel as (red, green, blue), each from 0 to 255. Outside the canvas, return
        `UNTOUCHED`.

        :param x: metres from the left edge of the canvas.
        :param y: metres from the upper edge of the canvas; y points down.
        """
        pixels = self._pixels
        x = x * METRE_PX + 0.5
        y = y * METRE_PX + 0.5
        if pixels is None or not (0.0 <= x < SIDE_PX and 0.0 <= y < SIDE_PX):
            return UNTOUCHED
        at = int(y) * _ROW + 3 * int(x)
        return pixels[at], pixels[at + 1], pixels[at + 2]

    def draw(self, pen: Pen, x0: float, y0: float, x1: float, y1: float) -> None:
        """Draw a line with a pen. The part outside the canvas is left out.

        :param x0: x coordinate of the start, in metres from the left edge of the canvas.
        :param y0: y coordinate of the start, in metres from the upper edge; y points down.
        :param x1: x coordinate of the end, in metres from the left edge of the canvas.
        :param y1: y coordinate of the end, in metres from the upper edge; y points down.
        """
        self.version += 1
        x0 *= METRE_PX
        y0 *= METRE_PX
        x1 *= METRE_PX
        y1 *= METRE_PX
        if x0 == pen.last_x and y0 == pen.last_y:
            reach = pen.reach
            if -reach < x1 - x0 < reach and -reach < y1 - y0 < reach and 0.0 <= x1 < SIDE_PX and 0.0 <= y1 < SIDE_PX:
                self._stamp(pen, x1, y1)
                pen.last_x = x1
                pen.last_y = y1
                return
        self._draw_squares(pen, x0, y0, x1, y1)

    def _draw_squares(self, pen: Pen, x0: float, y0: float, x1: float, y1: float) -> None:
        """Handle the unusual cases of :meth:`draw` (in pixels): a line that begins elsewhere, is long, or leaves the canvas."""
        if not (0.0 <= x0 < SIDE_PX and 0.0 <= y0 < SIDE_PX and 0.0 <= x1 < SIDE_PX and 0.0 <= y1 < SIDE_PX):
            visible = _visible_part(x0, y0, x1, y1)
            if visible is None:
                return
            x0, y0, x1, y1 = visible
        dx = x1 - x0
        dy = y1 - y0
        spacing = pen.reach
        if x0 != pen.last_x or y0 != pen.last_y:
            self._stamp(pen, x0, y0)
        if not (-spacing < dx < spacing and -spacing < dy < spacing):
            steps = int(max(abs(dx), abs(dy)) / spacing) + 1
            for step in range(1, steps):
                self._stamp(pen, x0 + dx * step / steps, y0 + dy * step / steps)
        self._stamp(pen, x1, y1)
        pen.last_x = x1
        pen.last_y = y1

    def _stamp(self, pen: Pen, x: float, y: float) -> None:
        """Draw a square of the pen's width around the pixel position (x, y)."""
        pixels = self._pixels
        if pixels is None:
            pixels = self._pixels = bytearray(b'\xff') * (_ROW * SIDE_PX)
        shift = pen.shift
        self._newest = pen
        pen.column = column = int(x + shift)
        pen.row = row = int(y + shift)
        column -= _MARGIN
        row -= _MARGIN
        edge = pen.edge
        if 0 <= column <= edge and 0 <= row <= edge:
            at = row * _ROW + 3 * column
            stroke = pen.stroke
            length = pen.length
            for start in range(at, at + pen.reach_rows, _ROW):
                pixels[start : start + length] = stroke
        else:
            _stamp_clipped(pixels, pen, column, row)


def _stamp_clipped(pixels: bytearray, pen: Pen, column: int, row: int) -> None:
    """Draw the part of a square that is on the canvas. `column` and `row` are the position of its upper left pixel."""
    left, right = max(column, 0), min(column + pen.width, SIDE_PX)
    if left < right:
        stroke = pen.stroke[: 3 * (right - left)]
        for line in range(max(row, 0), min(row + pen.width, SIDE_PX)):
            pixels[line * _ROW + 3 * left : line * _ROW + 3 * right] = stroke


def _visible_part(x0: float, y0: float, x1: float, y1: float) -> tuple[float, float, float, float] | None:
    """Return the part of a line (in pixels) that is on the canvas, or close enough to it for a broad pen. Return None without
    such a part.

    A line with infinity or nan has no such part.
    """
    enter, leave = 0.0, 1.0
    for start, way in ((x0, x1 - x0), (y0, y1 - y0)):
        to_low, to_high = -128.0 - start, SIDE_PX + 128.0 - start
        if way:
            near, far = sorted((to_low / way, to_high / way))
            enter, leave = max(enter, near), min(leave, far)
        elif not to_low <= 0.0 <= to_high:
            return None
    if not enter <= leave or not abs(x1 - x0) + abs(y1 - y0) < 1e300:
        return None
    return x0 + enter * (x1 - x0), y0 + enter * (y1 - y0), x0 + leave * (x1 - x0), y0 + leave * (y1 - y0)
