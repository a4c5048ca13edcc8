"""What a run broadcast of each tf frame, read once for all rules about it."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.recording import Recording

TF_TYPE = 'tf2_msgs/msg/TFMessage'
TINY = 1e-9
CLOCK_NS = 3_000_000_000
"""Further from the moment of broadcast no stamp is."""


class Broadcasts:
    """All that one node broadcast of one frame in one parent.

    :ivar poses: of static ones the different values, in order.
    :ivar odd: what was wrong with some of the transforms: 'zero', 'nan', 'unstamped', 'clock' -> (time in s, number of it).
    :ivar lag_s: how old the first transform was when it was broadcast; negative: from the future.
    """

    def __init__(self, node: str, parent: str, child: str, is_static: bool, time_ns: int) -> None:
        self.node, self.parent, self.child, self.is_static = node, parent, child, is_static
        self.first_ns = self.last_ns = time_ns
        self.count = 0
        self.poses: list[tuple[float, ...]] = []
        self.odd: dict[str, tuple[float, int]] = {}
        self.lag_s = 0.0

    @property
    def first_s(self) -> float:
        """When the first was broadcast."""
        return self.first_ns / 1e9

    def _note(self, what: str) -> None:
        time_s, count = self.odd.get(what, (self.last_ns / 1e9, 0))
        self.odd[what] = (time_s, count + 1)

    def look(self, start_ns: int, sec: int, nanosec: int, pose: tuple[float, ...]) -> None:
        """Count one transform, and see what is odd about it."""
        x, y, z, qx, qy, qz, qw = pose
        square = qx * qx + qy * qy + qz * qz + qw * qw
        check = square + x + y + z
        if check != check:
            self._note('nan')
        elif square < TINY:
            self._note('zero')
        if self.is_static:
            if pose not in self.poses:
                self.poses.append(pose)
            return
        stamp_ns = sec * 10**9 + nanosec
        if not stamp_ns:
            self._note('unstamped')
        elif not -CLOCK_NS < (lag_ns := start_ns + self.last_ns - stamp_ns) < CLOCK_NS:
            self._note('clock')
            self.lag_s = self.lag_s or lag_ns / 1e9


@lru_cache(maxsize=1)
def broadcasts(recording: Recording) -> list[Broadcasts]:
    """In order of the first of each; static ones before the others."""
    found: dict[Any, Broadcasts] = {}
    for topic, is_static in (('/tf_static', True), ('/tf', False)):
        for time_ns, node, wire in recording.published(topic, TF_TYPE):
            for sec, nanosec, parent, child, *pose in wire[0]:
                key = (node, parent, child, is_static)
                known = found.get(key)
                if known is None:
                    known = found[key] = Broadcasts(node, parent, child, is_static, time_ns)
                known.last_ns = time_ns
                known.count += 1
                known.look(recording.start_ns, sec, nanosec, tuple(pose))
    return list(found.values())


@lru_cache(maxsize=1)
def by_child(recording: Recording) -> dict[str, list[Broadcasts]]:
    """By frame; names without a leading slash, as tf2 keeps them."""
    found: dict[str, list[Broadcasts]] = {}
    for one in broadcasts(recording):
        found.setdefault(one.child.removeprefix('/'), []).append(one)
    return found


def frame_names(recording: Recording) -> list[str]:
    """All frames that were ever broadcast, parents too."""
    return list(dict.fromkeys(name.removeprefix('/') for one in broadcasts(recording) for name in (one.parent, one.child)))


def root_of(recording: Recording, frame: str) -> str:
    """The frame at the top of the tree in which a frame is."""
    links = by_child(recording)
    seen = [frame]
    while frame in links and (frame := links[frame][0].parent.removeprefix('/')) not in seen:
        seen.append(frame)
    return frame
