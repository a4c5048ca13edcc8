"""A stored path between two frames, and the transform along it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import sqrt

from edulaunch.engine.tf.history import History, poses_at
from edulaunch.engine.tf.quaternions import HUGE, TINY
from edulaunch.engine.tf.transforms import IDENTITY, Transform, canonical, product, relative

MAX_DEPTH = 1000


class Path:
    """The path from a source frame and from a target frame up to their first common ancestor.

    :param up: the histories of the frames from the source up to the last frame below the ancestor.
    :param down: the histories of the frames from the target up to the last frame below the ancestor.
    """

    __slots__ = ('_stamps', 'down', 'dynamic', 'up')

    def __init__(self, up: Sequence[History], down: Sequence[History]) -> None:
        self.up = up
        self.down = down
        self.dynamic = [history for history in (*up, *down) if not history.static]
        self._stamps = [history.stamps for history in self.dynamic]

    def latest_common_time(self) -> int:
        """Return the latest time in ns at which all frames have data, or 0 if all frames are static.

        The result is the oldest of the frames' newest stamps.
        """
        latest = 0
        for stamps in self._stamps:
            newest = stamps[-1]
            if newest and (newest < latest or not latest):
                latest = newest
        return latest

    def covers(self, time_ns: int) -> bool:
        """Return whether every frame has a pose at `time_ns`. For 0, return True."""
        if time_ns:
            for history in self.dynamic:
                if not history.stamps[history.first] <= time_ns <= history.stamps[-1]:
                    return False
        return True

    def at(self, time_ns: int) -> tuple[int, Transform] | None:
        """Return (time, target_from_source at that time), or None if a frame would need extrapolation.

        :param time_ns: the time in ns; 0 means the latest common time.
        """
        stamp_ns = time_ns or self.latest_common_time()
        found = IDENTITY
        if self.up:
            poses = poses_at(self.up, stamp_ns)
            if poses is None:
                return None
            found = product(poses)
        if self.down:
            poses = poses_at(self.down, stamp_ns)
            if poses is None:
                return None
            found = relative(product(poses), found)
        x, y, z, qx, qy, qz, qw = found
        square = qx * qx + qy * qy + qz * qz + qw * qw
        if 3.99 * qw * qw > square and TINY < square < HUGE:  # the common case of `canonical`, written out for speed
            s = 1.0 / sqrt(square) if qw > 0.0 else -1.0 / sqrt(square)
            return stamp_ns, (x + 0.0, y + 0.0, z + 0.0, qx * s + 0.0, qy * s + 0.0, qz * s + 0.0, qw * s)
        return stamp_ns, canonical(found)


def find_path(frames: Mapping[str, History | None], target: str, source: str) -> Path | None:
    """Return the path that follows the newest parents. Return None if there is no path, or if a parent changes over time.

    :param frames: the history of each frame by name; None for a frame without a parent.
    :param target: the name of the target frame, which must be in `frames`.
    :param source: the name of the source frame, which must be in `frames`.
    """
    up: list[History] = []
    place = {source: 0}
    frame = source
    while frame != target and (history := frames[frame]) is not None:
        if history.mixed or not history.stamps or len(up) == MAX_DEPTH:
            return None
        up.append(history)
        frame = history.parents[-1]
        if frame in place:  # the frames form a loop, which the exact search reports
            return None
        place[frame] = len(up)
    down: list[History] = []
    frame = target
    while frame not in place:
        history = frames[frame]
        if history is None or history.mixed or not history.stamps or len(down) == MAX_DEPTH:
            return None
        down.append(history)
        frame = history.parents[-1]
    return Path(up[: place[frame]], down)
