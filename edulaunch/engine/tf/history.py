"""The history of one child frame: its samples in order of time."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from math import acos, sin

from edulaunch.engine.tf.transforms import Transform

COMPACT_AT = 64


class History:
    """The samples of one child frame, oldest first: three parallel lists from index `first` on.

    Old samples are dropped by increasing `first`. The lists are cut when half of their entries have been dropped, so the cost
    of an insert does not depend on their length. A lookup at any time uses a bisection.

    :param name: the child frame.
    :param static: True for a frame of /tf_static: one sample, valid at all times.
    """

    __slots__ = ('authority', 'first', 'mixed', 'name', 'parents', 'poses', 'stamps', 'static')

    def __init__(self, name: str, static: bool) -> None:
        self.name = name
        self.static = static
        self.stamps: list[int] = []
        self.poses: list[Transform] = []  # each one is parent_from_child
        self.parents: list[str] = []
        self.first = 0
        self.mixed = False  # True while samples may name different parents
        self.authority = ''

    @property
    def count(self) -> int:
        """The number of stored samples."""
        return len(self.stamps) - self.first

    @property
    def newest(self) -> int:
        """The stamp of the newest sample in ns, or 0 for a static or empty history."""
        return self.stamps[-1] if self.stamps else 0

    @property
    def oldest(self) -> int:
        """The stamp of the oldest sample in ns, or 0 for a static or empty history."""
        return self.stamps[self.first] if self.stamps else 0

    def replace(self, parent: str, pose: Transform) -> None:
        """Replace all samples with a static transform without a stamp."""
        self.stamps[:], self.poses[:], self.parents[:] = [0], [pose], [parent]

    def forget(self) -> None:
        """Drop all samples."""
        self.stamps.clear()
        self.poses.clear()
        self.parents.clear()
        self.first = 0
        self.mixed = False

    def prune(self, horizon_ns: int) -> None:
        """Drop samples older than `horizon_ns`. The newest sample always stays."""
        stamps, first = self.stamps, self.first
        while stamps[first] < horizon_ns:
            first += 1
        self.first = first
        if first > COMPACT_AT and first * 2 > len(stamps):
            del self.stamps[:first], self.poses[:first], self.parents[:first]
            self.first = 0
            if self.mixed:
                self.mixed = any(parent != self.parents[-1] for parent in self.parents)

    def insert(self, parent: str, stamp_ns: int, pose: Transform) -> None:
        """Insert a sample in order of time. Do nothing if the history already contains the sample.

        Among samples with equal stamps, the new sample becomes the newest.

        :param parent: the name of the parent frame.
        :param stamp_ns: the time of the sample in ns.
        :param pose: parent_from_child: the pose of the frame in its parent, in metres, with a unit quaternion.
        """
        stamps = self.stamps
        if not stamps or stamp_ns > stamps[-1]:
            place = len(stamps)
        else:
            place = bisect_right(stamps, stamp_ns, self.first)
            index = place - 1
            while index >= self.first and stamps[index] == stamp_ns:
                if self.poses[index] == pose and self.parents[index] == parent:
                    return
                index -= 1
        if self.parents and self.parents[-1] != parent:
            self.mixed = True
        stamps.insert(place, stamp_ns)
        self.poses.insert(place, pose)
        self.parents.insert(place, parent)

    def pose_at(self, time_ns: int) -> Transform | None:
        """Return the pose at a time (0 means the newest), or None if it would need extrapolation. See :func:`poses_at`."""
        found = poses_at((self,), time_ns) if self.stamps else None
        return found[0] if found else None

    def sample(self, time_ns: int) -> tuple[Transform, str] | None:
        """Return (pose, parent) at a time, or None if the pose would need extrapolation.

        The pose is that of :meth:`pose_at`. Between samples with different parents, it is the pose of the older sample, without
        interpolation.
        """
        pose = self.pose_at(time_ns)
        if pose is None:
            return None
        newer = bisect_right(self.stamps, time_ns, self.first)
        if not self.mixed or time_ns == 0 or newer == len(self.stamps):
            return pose, self.parents[-1]
        older = self.first if time_ns == self.stamps[self.first] else newer - 1
        if self.parents[older] != self.parents[newer]:
            pose = self.poses[older]
        return pose, self.parents[older]


def poses_at(histories: Sequence[History], time_ns: int) -> list[Transform] | None:
    """Return the pose of each frame at a time (0 means the newest), or None if a pose would need extrapolation.

    Between two samples, the result is interpolated. At a stamp with several samples, the last inserted sample is used. At
    the oldest stamp, the first sample is used (as in tf2). The loop has no function call for each frame, because lookups in
    the past spend their time here.

    :param histories: the histories of the frames, which must not be empty.
    """
    poses: list[Transform] = []
    newer = 0  # stored between frames, because a robot mostly sends its frames together
    for history in histories:
        stamps = history.stamps
        if history.static or time_ns == stamps[-1] or not time_ns:
            poses.append(history.poses[-1])
            continue
        first = history.first
        if not (first < newer < len(stamps) and (older_ns := stamps[newer - 1]) <= time_ns < (newer_ns := stamps[newer])):
            newer = bisect_right(stamps, time_ns, first)
            if newer == first or newer == len(stamps):
                return None
            older_ns, newer_ns = stamps[newer - 1], stamps[newer]
        known = history.poses
        if time_ns == older_ns:
            poses.append(known[first if time_ns == stamps[first] else newer - 1])
            continue
        ratio = (time_ns - older_ns) / (newer_ns - older_ns)
        rest = 1.0 - ratio
        x, y, z, ax, ay, az, aw = known[newer - 1]
        u, v, w, bx, by, bz, bw = known[newer]
        turned = ax or ay or bx or by  # whether a rotation has an axis other than z; otherwise x and y are 0
        dot = ax * bx + ay * by + az * bz + aw * bw if turned else az * bz + aw * bw
        if -1.0 < dot < 1.0:  # spherical interpolation along the shorter arc
            theta = acos(dot) if dot > 0.0 else acos(-dot)
            scale = 1.0 / sin(theta)
            s = sin(rest * theta) * scale
            t = sin(ratio * theta) * (scale if dot > 0.0 else -scale)
            az, aw = az * s + bz * t, aw * s + bw * t
            if turned:
                ax, ay = ax * s + bx * t, ay * s + by * t
        poses.append((x * rest + u * ratio, y * rest + v * ratio, z * rest + w * ratio, ax, ay, az, aw))
    return poses
