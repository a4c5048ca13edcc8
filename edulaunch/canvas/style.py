"""The sizes, colours and fonts of all pictures, and the shapes of the turtle and the robot.

Wherever a colour has a meaning, a word, a shape or a line style has the same meaning.
"""

from __future__ import annotations

import math

Colour = tuple[int, int, int]

INK: Colour = (31, 41, 51)
MUTED: Colour = (91, 103, 112)
GRID: Colour = (226, 231, 236)
PAPER: Colour = (255, 255, 255)
BLUE: Colour = (38, 92, 178)
BLUE_TINT: Colour = (232, 240, 254)
SAND: Colour = (138, 109, 26)
SAND_TINT: Colour = (255, 248, 228)
GREEN: Colour = (30, 130, 76)
GREEN_TINT: Colour = (232, 246, 238)
ORANGE: Colour = (150, 78, 0)
RED: Colour = (192, 40, 32)
RED_TINT: Colour = (255, 240, 238)

SCALE = 2
"""The number of image pixels for each layout pixel, with which pictures are sharp on high-resolution screens."""

TEXT = 11.0
SMALL = 9.5
MONO_ADVANCE = 0.602
"""The width of any character of the monospaced font, relative to the font size; the layout of ROS names uses it."""
Part = tuple[str, list[tuple[float, float]]]
SHELLS: tuple[Colour, ...] = ((112, 173, 88), (236, 152, 70), (204, 74, 62), (158, 126, 190), (64, 176, 172), (240, 206, 72))
"""The colours of the turtles of a window, in order. Names beside the turtles give the same information."""
LOOKS: dict[str, Colour] = {'skin': (243, 233, 208), 'eye': (31, 41, 51), 'wheel': (31, 41, 51), 'body': (76, 106, 146)}
"""The fill colours of parts that are equal on all bodies. A shell's colour depends on its number, and plates are darker."""


def mono_width(text: str, size: float = TEXT) -> float:
    """Return the width of a string in the monospaced font, in pixels."""
    return len(text) * MONO_ADVANCE * size


def shortened(text: str, most: int = 28) -> str:
    """Return a string, shortened at its end to at most `most` characters."""
    return text if len(text) <= most else text[: most - 1] + '…'


def oval(x: float, y: float, rx: float, ry: float, turn: float = 0.0, steps: int = 16) -> list[tuple[float, float]]:
    """Return the corners of an ellipse, counter-clockwise and rounded to 0.001.

    :param x: the x coordinate of the centre.
    :param y: the y coordinate of the centre.
    :param rx: half of the length of the ellipse along x, before its rotation.
    :param ry: half of the length of the ellipse along y, before its rotation.
    :param turn: the angle of the rotation, in radians, counter-clockwise about the centre.
    :param steps: the number of corners. The first corner is at the end of `rx`.
    """
    angles = [math.tau * step / steps for step in range(steps)]
    c, s = math.cos(turn), math.sin(turn)
    return [
        (round(x + c * rx * math.cos(a) - s * ry * math.sin(a), 3), round(y + s * rx * math.cos(a) + c * ry * math.sin(a), 3))
        for a in angles
    ]


def turtle() -> list[Part]:
    """Return the shape of a turtle: flippers, a tail, a head with eyes, and a shell with one central plate and six plates around
    it.
    """
    parts: list[Part] = [('skin', oval(0.27, side * 0.33, 0.21, 0.085, side * 0.95, 12)) for side in (1, -1)]
    parts += [('skin', oval(-0.28, side * 0.29, 0.16, 0.075, -side * 0.85, 12)) for side in (1, -1)]
    parts += [('skin', [(-0.36, 0.06), (-0.54, 0.0), (-0.36, -0.06)]), ('skin', oval(0.46, 0.0, 0.155, 0.12))]
    parts += [('shell', oval(0.0, 0.0, 0.40, 0.34, steps=20))]
    inner, outer = oval(0.0, 0.0, 0.19, 0.17, steps=6), oval(0.0, 0.0, 0.37, 0.315, steps=6)
    parts += [('plate', inner)]
    parts += [('seam', [a, b]) for a, b in zip(inner, outer, strict=True)]
    parts += [('eye', oval(0.51, side * 0.062, 0.026, 0.026, steps=8)) for side in (1, -1)]
    return parts


def robot() -> list[Part]:
    """Return the shape of a round robot with two wheels and an arrow in its forward direction."""
    parts: list[Part] = [
        ('wheel', [(-0.2, side * 0.30), (0.2, side * 0.30), (0.2, side * 0.44), (-0.2, side * 0.44)]) for side in (1, -1)
    ]
    parts += [('body', oval(0.0, 0.0, 0.40, 0.36, steps=24)), ('nose', [(-0.08, 0.2), (0.32, 0.0), (-0.08, -0.2)])]
    return parts


def shade(colour: Colour, amount: float = 0.82) -> Colour:
    """Return a darker shade of a colour."""
    red, green, blue = (round(part * amount) for part in colour)
    return (red, green, blue)
