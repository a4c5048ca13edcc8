"""The tf tree of a run as plain data: which frame is whose parent, who broadcasts it, and how often."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.style import SMALL, TEXT, mono_width

if TYPE_CHECKING:
    from edulaunch.recording.frames import FrameLink
    from edulaunch.recording.recording import Recording

BETWEEN, LEVEL, LINE, MARGIN = 26, 46, 14, 16


class FrameBox(NamedTuple):
    """A frame: its text lines, its box (pixels: left and top from the upper left corner, width, height), its parent's position in
    the list (-1 for a root), how it is broadcast ('root', 'static' or 'dynamic'), and what is wrong with it or ''.
    """

    name: str
    lines: list[str]
    left: float
    top: float
    width: float
    height: float
    parent: int
    kind: str
    mark: str


class TreeScene(NamedTuple):
    """All trees side by side."""

    width: float
    height: float
    boxes: list[FrameBox]

    def caption(self) -> str:
        """One line that says what is to be seen."""
        roots = [box.name for box in self.boxes if box.parent < 0]
        links = [f'{self.boxes[box.parent].name} -> {box.name} ({", ".join(box.lines)})' for box in self.boxes if box.parent >= 0]
        apart = f'; {len(roots)} trees that are not connected: {", ".join(roots)}' if len(roots) > 1 else ''
        return '; '.join(links) + apart


def tree_scene(recording: Recording) -> TreeScene:
    """The tree of the whole run.

    :raises ValueError: when no frame was broadcast.
    """
    from edulaunch.recording.frames import frame_links
    links = frame_links(recording)
    if not links:
        raise ValueError('no tf frame was broadcast in this recording: nobody published to /tf or /tf_static')
    children: dict[str, list[str]] = {}
    for link in links.values():
        children.setdefault(link.parents[-1], []).append(link.child)
    roots = [name for name in children if name not in links] + _loops(links)
    boxes: list[FrameBox] = []
    left = float(MARGIN)
    for root in roots:
        left += _place(root, -1, left, MARGIN, links, children, boxes) + 2 * BETWEEN
    return TreeScene(left - 2 * BETWEEN + MARGIN, max(box.top + box.height for box in boxes) + MARGIN, boxes)


def _loops(links: dict[str, FrameLink]) -> list[str]:
    """One frame of each loop of parents, which has no root of its own."""
    starts, seen = [], set()
    for name in links:
        way = []
        while name in links and name not in seen:
            seen.add(name)
            way.append(name)
            name = links[name].parents[-1]
        if name in way:
            starts.append(name)
    return starts


def _lines(name: str, link: FrameLink | None) -> tuple[list[str], str, str]:
    """The text under a frame's name, how it is broadcast, and what is wrong."""
    if link is None:
        return ['root'], 'root', ''
    rate = link.rate_hz
    how = 'static' if link.is_static else 'once' if rate is None else f'{rate:.1f} Hz'
    mark = ''
    if len(link.parents) > 1:
        mark = f'{len(link.parents)} parents: {", ".join(link.parents)}'
    elif len(link.broadcasters) > 1:
        mark = f'{len(link.broadcasters)} broadcasters'
    return [how, *(f'by {node}' for node in link.broadcasters), *([mark] if mark else [])], 'static' if link.is_static else 'dynamic', mark


def _place(name: str, parent: int, left: float, top: float, links: dict[str, FrameLink], children: dict[str, list[str]],
           boxes: list[FrameBox]) -> float:
    """Put a frame above its children, from `left` on; returns the width that all of them need."""
    lines, kind, mark = _lines(name, links.get(name))
    if parent < 0 and kind != 'root':
        lines, mark = [*lines, 'part of a loop'], 'part of a loop'
    width = round(max(mono_width(name), *(mono_width(line, SMALL) for line in lines)) + 22)
    height = LINE * (len(lines) + 1) + 12
    here = len(boxes)
    boxes.append(FrameBox(name, lines, 0, top, width, height, parent, kind, mark))
    met = {box.name for box in boxes}
    ours = [child for child in children.get(name, []) if child not in met]
    span = float(-BETWEEN)
    widest = left
    for child in ours:
        step = _place(child, here, widest, top + height + LEVEL, links, children, boxes)
        span += step + BETWEEN
        widest += step + BETWEEN
    if ours and span < width:
        _shift(boxes, here + 1, (width - span) / 2)
    total = max(float(width), span)
    boxes[here] = boxes[here]._replace(left=round(left + (total - width) / 2))
    return total


def _shift(boxes: list[FrameBox], first: int, by: float) -> None:
    for number in range(first, len(boxes)):
        boxes[number] = boxes[number]._replace(left=boxes[number].left + round(by))
