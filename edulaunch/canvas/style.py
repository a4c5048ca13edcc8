"""Sizes, colours and the making of PNG bytes that are the same on every run."""
from __future__ import annotations

import io
from typing import Any

INK = '#1f2933'
PAPER = '#ffffff'
GRID = '#d9dee4'
DPI = 100
FONT = 'DejaVu Sans'


def new_figure(width_in: float, height_in: float) -> Any:
    """A matplotlib figure without pyplot: no window, no global state."""
    from matplotlib.figure import Figure
    return Figure(figsize=(width_in, height_in), dpi=DPI, facecolor=PAPER)


def to_png(figure: Any) -> bytes:
    """The figure as PNG without a date or a version in it."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format='png', metadata={'Software': None})
    return buffer.getvalue()
