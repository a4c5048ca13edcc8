"""Draw a planned or recorded system, or two systems side by side.

Nodes are ovals, topics are boxes, services have a double border, and frames have a thick border. A dashed box has unknown parts.
A sign before the name marks a difference: + and - exist only in this system, and ~ has changed.
"""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes

from edulaunch.canvas import style
from edulaunch.canvas.draw_graph import DASHED, LOOKS, draw_box, draw_route, write
from edulaunch.canvas.sheet import Box, Sheet, layout, rgb
from edulaunch.canvas.style import SMALL, TEXT, Colour
from edulaunch.canvas.system_scene import ADDED, CHANGED, GONE, SAME, Panel, SystemBox, SystemScene, lines_of

ABOVE, BELOW, BETWEEN = 24.0, 20.0, 16.0
WIDEST_PAIR = 640.0
"""The largest width of two panels side by side. Wider panels are one above the other."""
SIGNS: dict[str, Colour] = {ADDED: style.BLUE, GONE: style.ORANGE, CHANGED: style.INK, SAME: style.MUTED}
"""The colours of the signs. People with colour blindness can distinguish blue and orange, too. Red is only for errors."""
KINDS = {'node': 'oval: node', 'topic': 'box: topic', 'service': 'double border: service', 'frame': 'thick border: frame'}
WORDS = {ADDED: '+ only in this one', GONE: '- only in this one', CHANGED: '~ changed'}


def _size(scene: SystemScene) -> tuple[float, float]:
    return max(scene.width, 380.0), scene.height + ABOVE + BELOW


def system_sheet(scene: SystemScene) -> Sheet:
    """Return a sheet with space for each panel, the title above it and the legend below it."""
    width, height = _size(scene)
    if len(scene.panels) == 1:
        return Sheet(width, height, [Box(0, 0, width, height)])
    if width <= WIDEST_PAIR:
        right = width + BETWEEN
        return Sheet(right + width, height, [Box(0, 0, width, height), Box(right, 0, right + width, height)])
    upper = height + BETWEEN
    return Sheet(width, upper + height, [Box(0, upper, width, upper + height), Box(0, 0, width, height)])


def draw_system(scene: SystemScene, axes: Sequence[Axes]) -> None:
    """Draw each panel on the axes of that panel."""
    for ax, panel in zip(axes, scene.panels, strict=True):
        pixel = layout(ax, *_size(scene))
        ax.set_ylim(scene.height + BELOW, -ABOVE)
        ax.text(12, -8, panel.title, fontsize=TEXT * pixel, color=rgb(style.INK), fontweight='bold')
        for route, sign in zip(panel.routes, panel.signs, strict=True):
            draw_route(ax, route, scene.direction, SIGNS[sign], linestyle=DASHED if sign == GONE else '-')
        for box in panel.boxes:
            _draw_box(ax, box, pixel)
        ax.text(12, scene.height + 8, _legend(panel), fontsize=SMALL * pixel, color=rgb(style.MUTED))


def _legend(panel: Panel) -> str:
    kinds = {box.kind for box in panel.boxes}
    words = (
        ['oval: node', 'box: topic']
        + ['double border: service'] * ('service' in kinds)
        + ['thick border: frame'] * ('frame' in kinds)
    )
    words += ['dashed: not all is known'] * any(box.unknown for box in panel.boxes)
    signs = {box.sign for box in panel.boxes} | set(panel.signs)
    return '   '.join([*words, *(text for sign, text in WORDS.items() if sign in signs)])


def _draw_box(ax: Axes, box: SystemBox, pixel: float) -> None:
    fill, edge, radius = LOOKS.get(box.kind, (style.PAPER, style.INK, 7.0))
    if box.unknown:
        fill, edge = style.PAPER, style.MUTED
    if box.sign:
        edge = SIGNS[box.sign]
    wide = 2.2 if box.kind == 'frame' or box.sign else 1.3
    line = DASHED if box.unknown or box.sign == GONE else '-'
    draw_box(ax, box.left, box.top, box.width, box.height, radius, fill, edge, linewidth=wide, linestyle=line)
    if box.kind == 'service':
        draw_box(ax, box.left + 3, box.top + 3, box.width - 6, box.height - 6, 2, None, edge, linewidth=0.7)
    lines = lines_of(box.kind, box.name, box.notes)
    for number, (text, size, is_note) in enumerate(lines):
        y = box.top + box.height / 2 + (number - (len(lines) - 1) / 2) * 13.5
        signed = f'{box.sign} {text}' if box.sign and size == TEXT and not is_note else text
        write(ax, box.left + box.width / 2, y, signed, size * pixel, style.INK if size > SMALL or is_note else style.MUTED)


DRAWINGS: dict[type, tuple[object, object]] = {SystemScene: (system_sheet, draw_system)}
"""The function for the sheet of each kind of scene, and the function that draws the scene on that sheet's axes."""
