"""tf frames over time, read once and asked for many times."""

from __future__ import annotations

from bisect import bisect_right
from operator import itemgetter
from typing import TYPE_CHECKING

from edulaunch.canvas.composing import Placed, placed
from edulaunch.recording.frames import TOPICS, transform_wires
from edulaunch.recording.records import Frame

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording


class FrameTracks:
    """All transforms of a recording by child frame, in order of publication.

    As in tf2 a static transform replaces what came before, and among dynamic ones the newest counts.
    """

    def __init__(self, recording: Recording) -> None:
        self._rows: dict[str, list[tuple[float, Frame]]] = {}
        for topic, is_static in TOPICS:
            for published_s, (_, _, parent, child, x, y, z, qx, qy, qz, qw) in transform_wires(recording, topic):
                frame = Frame(parent, (x, y, z), (qx, qy, qz, qw), is_static, published_s)
                self._rows.setdefault(child, []).append((published_s, frame))

    @property
    def names(self) -> list[str]:
        """All child frames, in order of first appearance."""
        return list(self._rows)

    def frames_at(self, time_s: float) -> dict[str, Frame]:
        """The newest transform of each child frame at a time."""
        found = {}
        for name, rows in self._rows.items():
            position = bisect_right(rows, time_s, key=itemgetter(0))
            if position:
                found[name] = rows[position - 1][1]
        return found

    def placed_at(self, time_s: float) -> dict[str, Placed]:
        """Every frame in its root, at a time."""
        return placed(self.frames_at(time_s))
