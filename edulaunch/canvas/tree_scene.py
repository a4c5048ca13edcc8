"""The tf tree of a run as plain data: which frame is whose parent, who broadcasts it, and how often."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.layout import WIDEST, Point, lay_out
from edulaunch.canvas.style import SMALL, mono_width, shortened
from edulaunch.recording.absent import NothingToDraw

if TYPE_CHECKING:
    from edulaunch.recording.frames import FrameLink
    from edulaunch.recording.recording import Recording

LINE = 14.0


class FrameBox(NamedTuple):
    """A frame with the upper left corner and size of its box in pixels; `kind` is 'root', 'static' or 'dynamic'; `lines` say how
    often and by whom it is broadcast; `mark` says what is wrong with it, or ''.
    """

    name: str
    kind: str
    lines: list[str]
    left: float
    top: float
    width: float
    height: float
    mark: str


class TreeScene(NamedTuple):
    """All trees side by side: frames, links (parent, child) between their positions in the list, and each link's way."""

    width: float
    height: float
    boxes: list[FrameBox]
    links: list[tuple[int, int]]
    routes: list[list[Point]]
    direction: str

    def caption(self) -> str:
        """One line that says what is to be seen."""
        boxes = self.boxes
        links = [f'{boxes[parent].name} -> {boxes[child].name} ({", ".join(boxes[child].lines)})' for parent, child in self.links]
        roots = [box.name for box in boxes if box.kind == 'root']
        apart = f'; {len(roots)} trees that are not connected: {", ".join(roots)}' if len(roots) > 1 else ''
        wrong = [f'; {box.name}: {box.mark}' for box in boxes if box.mark]
        return '; '.join(links) + apart + ''.join(wrong)


def tree_scene(recording: Recording) -> TreeScene:
    """The tree of the whole run.

    :raises ValueError: when no frame was broadcast.
    """
    from edulaunch.recording.frames import frame_links

    found = frame_links(recording)
    if not found:
        raise NothingToDraw('no tf frame was broadcast in this recording: nobody published to /tf or /tf_static')
    names = list(dict.fromkeys(name for link in found.values() for name in (*link.parents, link.child)))
    place = {name: number for number, name in enumerate(names)}
    links = [(place[parent], place[link.child]) for link in found.values() for parent in link.parents]
    texts = [_lines(found.get(name)) for name in names]
    sizes = [_size(name, *text) for name, text in zip(names, texts, strict=True)]
    layout = lay_out(sizes, links, 'down')
    if layout.width > WIDEST:
        layout = lay_out(sizes, links, 'right')
    boxes = [
        FrameBox(name, _kind(found.get(name)), lines, *corner, *size, mark)
        for name, (lines, mark), corner, size in zip(names, texts, layout.corners, sizes, strict=True)
    ]
    return TreeScene(layout.width, layout.height, boxes, links, [route.points for route in layout.routes], layout.direction)


def _kind(link: FrameLink | None) -> str:
    return 'root' if link is None else 'static' if link.is_static else 'dynamic'


def _lines(link: FrameLink | None) -> tuple[list[str], str]:
    """The text under a frame's name, and what is wrong with it."""
    if link is None:
        return ['root'], ''
    rate = link.rate_hz
    how = 'static' if link.is_static else 'broadcast once' if rate is None else f'{rate:.1f} Hz'
    mark = (
        'its own parent'
        if link.child in link.parents
        else f'{len(link.parents)} parents'
        if len(link.parents) > 1
        else f'{len(link.broadcasters)} broadcasters'
        if len(link.broadcasters) > 1
        else ''
    )
    return [how, *(f'by {node}' for node in link.broadcasters)], mark


def _size(name: str, lines: list[str], mark: str) -> tuple[float, float]:
    width = max(mono_width(shortened(name)), *(mono_width(shortened(line), SMALL) for line in [*lines, mark]))
    return (float(round(width) + 22), LINE * (len(lines) + 1 + bool(mark)) + 12)
