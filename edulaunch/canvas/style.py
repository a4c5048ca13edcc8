"""Sizes, colours and fonts of all pictures. Whatever a colour says, a word, a shape or a line style says too."""

from __future__ import annotations

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
RED: Colour = (192, 40, 32)
RED_TINT: Colour = (255, 240, 238)

SCALE = 2
"""Image pixels per layout pixel: pictures stay sharp on fine screens."""

TEXT = 11.0
SMALL = 9.5
MONO_ADVANCE = 0.602
"""Width of any character of the monospaced font, in parts of the font size: ROS names are laid out with it."""


def mono_width(text: str, size: float = TEXT) -> float:
    """How wide a text in the monospaced font is, in pixels."""
    return len(text) * MONO_ADVANCE * size


def shortened(text: str, most: int = 28) -> str:
    """The text, its end left out where it is longer than `most` characters."""
    return text if len(text) <= most else text[: most - 1] + '…'
