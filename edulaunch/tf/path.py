"""The remembered way between two frames, and the product of the transforms along it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import sqrt

from edulaunch.tf.history import History
from edulaunch.tf.transforms import IDENTITY, Transform, canonical, relative

MAX_DEPTH = 1000


class Path:
    """From a source frame up to the first common ancestor, and from the target frame up to it.

    :param up: histories from the source to below the ancestor.
    :param down: histories from the target to below the ancestor.
    """

    __slots__ = ('down', 'dynamic', 'up')

    def __init__(self, up: Sequence[History], down: Sequence[History]) -> None:
        self.up = up
        self.down = down
        self.dynamic = [history for history in (*up, *down) if not history.static]

    def latest_common_time(self) -> int:
        """The oldest of the newest stamps; 0 when all is static."""
        latest = 0
        for history in self.dynamic:
            newest = history.stamps[-1]
            if newest and (newest < latest or not latest):
                latest = newest
        return latest

    def covers(self, time_ns: int) -> bool:
        """Whether every history can tell its pose at `time_ns` (0: always)."""
        if time_ns:
            for history in self.dynamic:
                if not history.stamps[history.first] <= time_ns <= history.stamps[-1]:
                    return False
        return True

    def transform(self, time_ns: int) -> Transform | None:
        """target_from_source at `time_ns`, or None when something would have to be extrapolated."""
        found = climb(self.up, time_ns) if self.up else IDENTITY
        if self.down and found is not None:
            down = climb(self.down, time_ns)
            found = None if down is None else relative(down, found)
        if found is None:
            return None
        x, y, z, qx, qy, qz, qw = found
        if qw > 0.501:  # the common case of `canonical`, written out for speed
            s = 1.0 / sqrt(qx * qx + qy * qy + qz * qz + qw * qw)
            return (x + 0.0, y + 0.0, z + 0.0, qx * s + 0.0, qy * s + 0.0, qz * s + 0.0, qw * s)
        return canonical(found)


def find_path(frames: Mapping[str, History | None], target: str, source: str) -> Path | None:
    """The path by the newest parents; None when there is none, or when it is not the same at all times."""
    up: list[History] = []
    place = {source: 0}
    frame = source
    while frame != target and (history := frames[frame]) is not None:
        if history.mixed or not history.stamps or len(up) == MAX_DEPTH:
            return None
        up.append(history)
        frame = history.parents[-1]
        if frame in place:  # a loop: the exact walk reports it
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


def climb(histories: Sequence[History], time_ns: int) -> Transform | None:
    """The product of the samples at `time_ns`, from the bottom to the top; None when one has to be
    extrapolated.

    The inner loop of every lookup, so the composition of transforms.py is written out here.
    """
    pose = histories[0].pose_at(time_ns)
    if pose is None:
        return None
    x, y, z, qx, qy, qz, qw = pose
    for history in histories[1:]:
        if time_ns == history.stamps[-1] or history.static:
            px, py, pz, ax, ay, az, aw = history.poses[-1]
        else:
            pose = history.pose_at(time_ns)
            if pose is None:
                return None
            px, py, pz, ax, ay, az, aw = pose
        ux = 2.0 * (ay * z - az * y)
        uy = 2.0 * (az * x - ax * z)
        uz = 2.0 * (ax * y - ay * x)
        x += px + aw * ux + ay * uz - az * uy
        y += py + aw * uy + az * ux - ax * uz
        z += pz + aw * uz + ax * uy - ay * ux
        bx, by, bz = qx, qy, qz
        qx = aw * bx + ax * qw + ay * bz - az * by
        qy = aw * by - ax * bz + ay * qw + az * bx
        qz = aw * bz + ax * by - ay * bx + az * qw
        qw = aw * qw - ax * bx - ay * by - az * bz
    return (x, y, z, qx, qy, qz, qw)
