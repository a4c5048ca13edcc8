"""Texts as outlines. Drawing outlines is many times faster than matplotlib's text, and the same on each machine: no hinting."""

from __future__ import annotations

import os
from functools import cache
from typing import Any

import matplotlib
import numpy as np
from matplotlib import ft2font
from matplotlib.path import Path

FILES = {'sans': 'DejaVuSans.ttf', 'bold': 'DejaVuSans-Bold.ttf', 'mono': 'DejaVuSansMono.ttf'}
EM = 64.0
"""Font size at which outlines are read."""


@cache
def _font(name: str) -> Any:
    font = ft2font.FT2Font(os.path.join(matplotlib.get_data_path(), 'fonts', 'ttf', FILES[name]))
    font.set_size(EM, 72)
    return font


def _no_hinting() -> Any:
    """The flag that asks for outlines as they were designed; matplotlib moved it in 3.10."""
    flags = getattr(ft2font, 'LoadFlags', None)
    return getattr(ft2font, 'LOAD_NO_HINTING') if flags is None else flags.NO_HINTING  # noqa: B009


@cache
def _glyph(name: str, character: str) -> tuple[Any, Any, float]:
    """Vertices and codes of the outline of a character, and how far the next one stands; in parts of the font size."""
    font = _font(name)
    glyph = font.load_char(ord(character), flags=_no_hinting())
    vertices, codes = font.get_path()
    return np.asarray(vertices, dtype=float).reshape(-1, 2) / EM, codes, glyph.linearHoriAdvance / 65536 / EM


def text_width(text: str, size: float, font: str = 'sans') -> float:
    """How wide a line of text is, in the unit of `size`."""
    return size * sum(_glyph(font, character)[2] for character in text)


def text_path(text: str, size: float, x: float, y: float, font: str = 'sans') -> Path | None:
    """The outline of a line of text whose baseline starts at (x, y); None when there is nothing to draw."""
    vertices, codes = [], []
    for character in text:
        outline, kinds, advance = _glyph(font, character)
        if len(outline):
            vertices.append(outline * size + (x, y))
            codes.append(kinds)
        x += advance * size
    return Path(np.concatenate(vertices), np.concatenate(codes)) if vertices else None
