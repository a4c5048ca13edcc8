"""Lookups step by step in the same order as tf2, so that failures have tf2's own messages.

`path.py` handles the usual lookups faster. This module handles the other lookups: failures, and frames whose parent has
changed.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from edulaunch.engine.tf.dumps import all_frames_as_string, seconds_text
from edulaunch.engine.tf.failure import CONNECTIVITY, EXTRAPOLATION, LOOKUP, TransformFailure
from edulaunch.engine.tf.history import History
from edulaunch.engine.tf.path import MAX_DEPTH
from edulaunch.engine.tf.transforms import IDENTITY, Transform, canonical, compose, relative

Histories = Mapping[str, 'History | None']


def walk(frames: Histories, target: str, source: str, time_ns: int) -> tuple[int, Transform]:
    """Return (stamp in ns, target_from_source) for the frames `target` and `source`.

    :param time_ns: the time in ns; 0 means the latest common time.
    :raises TransformFailure: with tf2's message.
    """
    if target == source:
        return time_ns, IDENTITY
    if time_ns == 0:
        time_ns = latest_common_time(frames, target, source)
    top_from_source, top, source_failed = _climb(frames, source, (target,), time_ns)
    if top == target:
        return time_ns, canonical(top_from_source)
    reached_from_target, reached, target_failed = _climb(frames, target, (top, source), time_ns)
    if reached == source:
        return time_ns, canonical(relative(reached_from_target, IDENTITY))
    if reached == top:
        return time_ns, canonical(relative(reached_from_target, top_from_source))
    failed = source_failed if target_failed is None else target_failed
    if failed is None:
        raise _unconnected(target, source)
    raise TransformFailure(
        EXTRAPOLATION, f'{_extrapolation(failed, time_ns)}, when looking up transform from frame [{source}] to frame [{target}]'
    )


def latest_common_time(frames: Histories, target: str, source: str) -> int:
    """Return the newest time in ns at which every frame on the path has data, or 0 if all frames are static.

    :raises TransformFailure: if the frames are not connected, or form a loop.
    """
    if target == source:
        history = frames[source]
        return history.newest if history is not None else 0
    source_side = _newest_upward(frames, source, (target,))
    if source_side and source_side[-1][1] == target:
        return _minimum(stamp for stamp, _ in source_side)
    known = {parent for _, parent in source_side}
    target_side = _newest_upward(frames, target, (source, *known))
    if not target_side or (target_side[-1][1] != source and target_side[-1][1] not in known):
        raise _unconnected(target, source)
    stamps = [stamp for stamp, _ in target_side]
    meeting = target_side[-1][1]
    if meeting != source:
        for stamp, parent in source_side:
            stamps.append(stamp)
            if parent == meeting:
                break
    return _minimum(stamps)


def chain(frames: Histories, target: str, source: str, time_ns: int) -> list[str]:
    """Return the frames on the path from `source` through the first common ancestor to `target`, including `source` and
    `target`.

    :raises TransformFailure: if there is no such path at `time_ns`.
    """
    walk(frames, target, source, time_ns)
    up = _ancestors(frames, source, time_ns)
    down = _ancestors(frames, target, time_ns)
    meeting = next(frame for frame in up if frame in down)
    return up[: up.index(meeting) + 1] + down[: down.index(meeting)][::-1]


def _ancestors(frames: Histories, frame: str, time_ns: int) -> list[str]:
    found = [frame]
    while (history := frames[frame]) is not None and (sample := history.sample(time_ns)) is not None:
        frame = sample[1]
        if frame in found:
            break
        found.append(frame)
    return found


def _climb(frames: Histories, frame: str, stops: tuple[str, ...], time_ns: int) -> tuple[Transform, str, History | None]:
    """Return (reached_from_start, the frame that was reached, and the history without a sample at that time or None)."""
    pose = IDENTITY
    steps = 0
    while frame not in stops and (history := frames[frame]) is not None:
        sample = history.sample(time_ns)
        if sample is None:
            return pose, frame, history
        pose, frame = compose(sample[0], pose), sample[1]
        steps += 1
        if steps > MAX_DEPTH:
            raise _loop(frames)
    return pose, frame, None


def _newest_upward(frames: Histories, frame: str, stops: tuple[str, ...]) -> list[tuple[int, str]]:
    """Return (newest stamp, newest parent) of each frame on the way up. Stop when a parent is in `stops`."""
    found: list[tuple[int, str]] = []
    while (history := frames[frame]) is not None and history.stamps:
        frame = history.parents[-1]
        found.append((history.newest, frame))
        if frame in stops:
            break
        if len(found) > MAX_DEPTH:
            raise _loop(frames)
    return found


def _minimum(stamps: Iterable[int]) -> int:
    return min((stamp for stamp in stamps if stamp), default=0)


def _extrapolation(history: History, time_ns: int) -> str:
    wanted, newest = seconds_text(time_ns), seconds_text(history.newest)
    if not history.stamps:
        return ''
    if history.count == 1:
        return f'Lookup would require extrapolation at time {wanted}, but only time {newest} is in the buffer'
    if time_ns > history.newest:
        return (
            'Lookup would require extrapolation into the future.  '
            f'Requested time {wanted} but the latest data is at time {newest}'
        )
    return (
        'Lookup would require extrapolation into the past.  '
        f'Requested time {wanted} but the earliest data is at time {seconds_text(history.oldest)}'
    )


def _unconnected(target: str, source: str) -> TransformFailure:
    return TransformFailure(
        CONNECTIVITY,
        f"Could not find a connection between '{target}' and '{source}' because they "
        'are not part of the same tree.Tf has two or more unconnected trees.',
    )


def _loop(frames: Histories) -> TransformFailure:
    return TransformFailure(LOOKUP, f'The tf tree is invalid because it contains a loop.\n{all_frames_as_string(frames)}\n')
