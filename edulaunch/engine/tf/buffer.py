"""The time-ordered buffer of transforms: tf2's BufferCore without ROS messages.

Times are integer nanoseconds; 0 means "the latest common time". `tf2_py` turns messages into these numbers.
"""

from __future__ import annotations

from math import sqrt

from edulaunch.engine.tf import dumps
from edulaunch.engine.tf.failure import TransformFailure
from edulaunch.engine.tf.frame_names import check_name, check_names, problem
from edulaunch.engine.tf.history import History
from edulaunch.engine.tf.path import Path, find_path
from edulaunch.engine.tf.quaternions import HUGE, TINY
from edulaunch.engine.tf.rejection import Rejection, reasons_against, too_old
from edulaunch.engine.tf.transforms import IDENTITY, Transform, canonical, compose
from edulaunch.engine.tf.walk import chain, latest_common_time, walk

DEFAULT_CACHE_NS = 10_000_000_000
ACCEPTED: tuple[Rejection, ...] = ()


class TransformBuffer:
    """The transforms of a tree of frames over the last seconds.

    :param cache_ns: the length of each frame's history before its newest sample, in ns.
    """

    def __init__(self, cache_ns: int = DEFAULT_CACHE_NS) -> None:
        self.cache_ns = cache_ns
        # Frames in the order of their first mention; a frame without a parent has the value None.
        self._frames: dict[str, History | None] = {}
        # These paths are valid until a parent changes.
        self._paths: dict[tuple[str, str], Path] = {}

    def set(
        self, parent: str, child: str, stamp_ns: int, pose: Transform, authority: str = 'default_authority', static: bool = False
    ) -> tuple[Rejection, ...]:
        """Add one transform: `pose` (metres, and (x, y, z, w)) of the frame `child` relative to `parent` at `stamp_ns`.

        :param authority: the name of the node that broadcasts the transform.
        :param static: whether the transform is valid at all times. The stamp then has no effect.
        :returns: the log lines with which tf2 rejects the transform, as (severity, string); empty if the transform was accepted.
        """
        x, y, z, qx, qy, qz, qw = pose
        square = qx * qx + qy * qy + qz * qz + qw * qw
        if qw > 0.0 and 4.0 * qw * qw > square > TINY and square < HUGE:
            # the common case of quaternions.canonical, written out for speed
            if square != 1.0:
                scale = 1.0 / sqrt(square)
                pose = (x, y, z, qx * scale, qy * scale, qz * scale, qw * scale)
        else:
            pose = canonical(pose)
            square = pose[6]
        check = square + x + y + z  # the sum is nan if one of them is
        history = self._frames.get(child)
        if history is None or history.static or static or not history.stamps or history.parents[-1] != parent or check != check:
            return self._set_with_care(parent, child, stamp_ns, pose, authority, static)
        newest = history.stamps[-1]
        horizon = newest - self.cache_ns
        if history.stamps[history.first] < horizon:
            history.prune(horizon)
        if stamp_ns > newest:
            history.stamps.append(stamp_ns)
            history.poses.append(pose)
            history.parents.append(parent)
        elif stamp_ns < horizon:
            return too_old(child, stamp_ns, authority)
        else:
            history.insert(parent, stamp_ns, pose)
        history.authority = authority
        return ACCEPTED

    def _set_with_care(
        self, parent: str, child: str, stamp_ns: int, pose: Transform, authority: str, static: bool
    ) -> tuple[Rejection, ...]:
        """Handle the unusual cases of :meth:`set`: new frames, new parents, static transforms, invalid input."""
        parent, child = parent.removeprefix('/'), child.removeprefix('/')
        rejections = reasons_against(parent, child, pose, authority)
        if rejections:
            return rejections
        history = self._frames.get(child)
        if history is None or history.static != static:
            history = self._frames[child] = History(child, static)
        self._frames.setdefault(parent)
        self._paths.clear()
        history.authority = authority
        if static:
            history.replace(parent, pose)
            return ACCEPTED
        if history.stamps:
            horizon = history.newest - self.cache_ns
            history.prune(horizon)
            if stamp_ns < horizon:
                return too_old(child, stamp_ns, authority)
        history.insert(parent, stamp_ns, pose)
        return ACCEPTED

    def clear(self) -> None:
        """Remove the samples of all dynamic frames. The names of frames and static transforms stay."""
        for history in self._frames.values():
            if history is not None and not history.static:
                history.forget()
        self._paths.clear()

    def lookup(self, target: str, source: str, time_ns: int = 0) -> tuple[int, Transform]:
        """Return (stamp in ns, target_from_source) for the frames `target` and `source`, interpolated between samples.

        :param time_ns: the time in ns; 0 means the latest common time.
        :raises TransformFailure: for an unknown name, a missing connection, or a time without data.
        """
        path = self._paths.get((target, source))
        if path is None:
            if target == source:  # checked before the names, as in tf2
                return time_ns or self._newest(source), IDENTITY
            check_names(self._frames, target, source)
            path = self._remember_path(target, source)
        if path is not None:
            found = path.at(time_ns)
            if found is not None:
                return found
        return walk(self._frames, target, source, time_ns)

    def lookup_full(self, target: str, target_ns: int, source: str, source_ns: int, fixed: str) -> tuple[int, Transform]:
        """Return (stamp in ns, transform from `source` at `source_ns` to `target` at `target_ns`).

        The two times are connected by the frame `fixed`, which does not move between them.

        :raises TransformFailure: as in :meth:`lookup`, for any of the three names.
        """
        check_names(self._frames, target, source, fixed)
        stamp_ns, target_from_fixed = self.lookup(target, fixed, target_ns)
        return stamp_ns, canonical(compose(target_from_fixed, self.lookup(fixed, source, source_ns)[1]))

    def can_transform(self, target: str, source: str, time_ns: int = 0) -> tuple[bool, str]:
        """Return whether `lookup(target, source, time_ns)` would succeed, and the reason if it would not ('' otherwise)."""
        path = self._paths.get((target, source))
        if target == source or path is not None and path.covers(time_ns or path.latest_common_time()):
            return True, ''
        return self._try(problem(self._frames, target, source), target, source, time_ns)

    def can_transform_full(self, target: str, target_ns: int, source: str, source_ns: int, fixed: str) -> tuple[bool, str]:
        """Return whether `lookup_full(target, target_ns, source, source_ns, fixed)` would succeed, and the reason (or '')."""
        possible, reason = self._try(problem(self._frames, target, source, fixed), target, fixed, target_ns)
        return self._try('', fixed, source, source_ns) if possible else (False, reason)

    def latest_common_time(self, target: str, source: str) -> int:
        """Return the latest time in ns of the transform from `source` to `target`, or 0 if the whole path is static.

        :raises TransformFailure: for an unknown name, or a missing connection.
        """
        check_name(self._frames, target, 'get_latest_common_time')
        check_name(self._frames, source, 'get_latest_common_time')
        return latest_common_time(self._frames, target, source)

    def chain(self, target: str, target_ns: int, source: str, source_ns: int, fixed: str) -> list[str]:
        """Return the frames on the path of `lookup_full(target, target_ns, source, source_ns, fixed)`, or raise its error."""
        check_names(self._frames, target, source, fixed)
        below = chain(self._frames, fixed, source, source_ns)
        return below + chain(self._frames, target, fixed, target_ns)[1:]

    def frame_exists(self, name: str) -> bool:
        """Return whether the buffer has received a transform that names the frame `name`."""
        return name in self._frames

    def frame_names(self) -> list[str]:
        """Return all frames in the order in which they were first named."""
        return list(self._frames)

    def all_frames_as_yaml(self) -> str:
        """Return all frames as YAML; see :func:`edulaunch.engine.tf.dumps.all_frames_as_yaml`."""
        return dumps.all_frames_as_yaml(self._frames)

    def all_frames_as_string(self) -> str:
        """Return all frames as lines; see :func:`edulaunch.engine.tf.dumps.all_frames_as_string`."""
        return dumps.all_frames_as_string(self._frames)

    def all_frames_as_dot(self, now_ns: int = 0) -> str:
        """Return the tree as a graphviz graph at the time `now_ns`; see :func:`edulaunch.engine.tf.dumps.all_frames_as_dot`."""
        return dumps.all_frames_as_dot(self._frames, now_ns)

    def _newest(self, frame: str) -> int:
        history = self._frames.get(frame)
        return 0 if history is None else history.newest

    def _remember_path(self, target: str, source: str) -> Path | None:
        path = find_path(self._frames, target, source)
        if path is not None:
            self._paths[target, source] = path
        return path

    def _try(self, reason: str, target: str, source: str, time_ns: int) -> tuple[bool, str]:
        if reason:
            return False, reason
        try:
            self.lookup(target, source, time_ns)
        except TransformFailure as failure:
            return False, str(failure)
        return True, ''
