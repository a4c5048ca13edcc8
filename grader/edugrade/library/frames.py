"""Checks of tf frames."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from math import asin, atan2, cos, hypot, sin
from re import sub
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.engine.recording.records import Frame

from ..evidence import Advice, Evidence, Failure, Missing
from .identity import nodes_of, process_of
from .movement import turtle_track
from .node_graph import loose_ends
from .parameters import parameter_advice, parameter_of

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

Frames = Mapping[str, Frame]
BROADCASTER = ('turtle_tf2_py', 'turtle_tf2_broadcaster')
LATE_S, OFF_M = 0.5, 0.1  # largest delay of a frame, and largest error of its position
LAST_S = 1.0  # greatest age of the last transform of a moving frame that exists until the end


class Sent(NamedTuple):
    """A published transform and its time."""

    time_s: float
    frame: Frame


def frames_at_end(run: Evidence, scenario: str) -> Frames:
    """Return all frames at the end of a run, by name."""
    recording = run[scenario]
    return run.once(('frames', scenario), lambda: recording.frames_at(recording.duration_s))


def transforms(run: Evidence, scenario: str) -> Mapping[str, Sequence[Sent]]:
    """Return all published transforms of each frame in order of publication, by the frame's name. Static transforms come
    first.
    """
    return run.once(('transforms', scenario), lambda: _transforms(run[scenario]))


def _transforms(recording: Recording) -> dict[str, list[Sent]]:
    from edulaunch.engine.recording.frames import TOPICS, transform_wires

    found: dict[str, list[Sent]] = {}
    for topic, is_static in TOPICS:
        for time_s, (sec, nanosec, parent, child, x, y, z, *rotation) in transform_wires(recording, topic):
            stamp_s = (sec * 10**9 + nanosec - recording.start_ns) / 1e9
            found.setdefault(child, []).append(Sent(time_s, Frame(parent, (x, y, z), tuple(rotation), is_static, stamp_s)))
    return found


def require_frame(run: Evidence, child: str, parent: str, try_: Advice | Sequence[str], hint_seen: str = '') -> None:
    """Require a frame in every run, from the middle of the run at the latest until its end, always with the right parent.

    :param hint_seen: another observation that explains why the frame is missing.
    :raises Missing: if the frame does not exist, with the names of the existing frames.
    :raises Failure: if the frame has another parent even once, appears late, or is no longer published. A frame in `world`
        must also have the position of its turtle.
    """
    for scenario in run:
        everything = transforms(run, scenario)
        sent = everything.get(child)
        if any(item.frame.parent == child for item in everything.get(parent, ())):
            try_ = f'exchange the parent and the child: {child} should have the parent {parent}'
        if sent is None:
            raise _absent(run, scenario, child, parent, try_, hint_seen)
        words = run.scenario(scenario).words
        elsewhere = next((item for item in sent if item.frame.parent != parent), None)
        if elsewhere is not None:
            other, now_and_then = elsewhere.frame.parent, any(item.frame.parent == parent for item in sent)
            raise Failure(
                f'the parent of the frame {child} is not {parent} in the run with {words}',
                expected=f'the parent {parent}',
                seen=f'the parent {other}' + (f' at {elsewhere.time_s:.2f} s' if now_and_then else ''),
                where=run.source.place,
                try_=f'remove the parent {other} of {child}, because a frame has only one parent' if now_and_then else try_,
                name=parent,
                among=_misspelt(parent, {elsewhere.frame.parent} - set(frames_at_end(run, scenario))),
            )
        _require_all_the_time(run, scenario, child, sent, try_)
        if parent == 'world':
            _require_truth(run, scenario, child, sent, try_)


def _absent(run: Evidence, scenario: str, child: str, parent: str, try_: Advice | Sequence[str], hint_seen: str) -> Failure:
    """Return the failure of a frame that no node broadcasts, or that is only a parent of other frames."""
    frames = frames_at_end(run, scenario)
    known = ', '.join(f'{name} (parent {frame.parent})' for name, frame in frames.items()) or 'no frames'
    is_a_parent = any(item.frame.parent == child for items in transforms(run, scenario).values() for item in items)
    seen, expected = '\n'.join(filter(None, (known, hint_seen))), f'the frame {child} with the parent {parent}'
    among, where = _misspelt(child, frames), run.source.place
    if is_a_parent:
        thing = f'the frame {child} has no parent'
        return Failure(thing, expected=expected, seen=seen, where=where, try_=try_, name=child, among=among)
    return Missing(f'the frame {child}', name=child, among=among, where=where, try_=try_, seen=seen, expected=expected)


def require_broadcast(run: Evidence, turtle: str, try_: Advice) -> None:
    """Require the frame of a turtle relative to `world`, as in :func:`require_frame`.

    If a turtle_tf2_broadcaster broadcasts no turtle, or the same turtle as another one, the report names its place and its
    parameter.

    :param try_: the advice for a launch file without such a broadcaster.
    """
    recording, known = run.first, set[object]()
    for position in nodes_of(recording, *BROADCASTER):
        name, process = (
            parameter_of(recording, position, 'turtlename'),
            process_of(recording, recording.nodes[position], position),
        )
        value = name.value if name is not None else ''
        if value not in known and f'/{value}/pose' in recording.topics and turtle_track(recording, f'/{value}/pose'):
            known.add(value)
        elif process is not None:
            advice = parameter_advice(run, 'turtlename', turtle, name, process.parameter_origins, f'set turtlename to {turtle}')
            break
    else:
        return require_frame(run, turtle, 'world', try_)
    try:
        node = recording.nodes[position].name
        loose = [words for words in loose_ends(recording, *BROADCASTER) if words.startswith(f'{node} ')]
        require_frame(run, turtle, 'world', advice, next(iter(loose), f'{node} broadcasts the frame of {value}'))
    except Failure as failure:
        failure.where = run.source.own(process.origin)
        raise


def _require_truth(run: Evidence, scenario: str, turtle: str, sent: Sequence[Sent], try_: Advice | Sequence[str]) -> None:
    """Require that the frame of a turtle always has the position of the turtle in the simulator.

    :raises Failure: with both positions.
    """
    track = turtle_track(run[scenario], f'/{turtle}/pose') if f'/{turtle}/pose' in run[scenario].topics else []
    times = [sample[0] for sample in track]
    for item in sent if track else ():
        newest = bisect_right(times, item.time_s)
        recent = track[max(0, bisect_right(times, item.time_s - LATE_S) - 1) : newest]
        x, y, _ = item.frame.translation
        away = min((hypot(sample[1] - x, sample[2] - y) for sample in recent), default=0.0)
        wrong = recent[-1] if not away <= OFF_M else None
        if item.frame.is_static:  # a static transform holds from now on, and is sent once
            wrong = next((sample for sample in track if not hypot(sample[1] - x, sample[2] - y) <= OFF_M), wrong)
        if wrong is not None:
            raise Failure(
                f'the frame {turtle} is not where {turtle} is in the run with {run.scenario(scenario).words}',
                expected=f'{numbers(wrong[1:])} at {wrong[0]:.2f} s, the position in the simulator',
                seen=numbers((x, y)),
                where=run.source.place,
                try_=try_,
            )


def _require_all_the_time(run: Evidence, scenario: str, child: str, sent: Sequence[Sent], try_: Advice | Sequence[str]) -> None:
    duration_s = run[scenario].duration_s
    first_s, last_s = min(item.time_s for item in sent), max(item.time_s for item in sent)
    stays = all(item.frame.is_static for item in sent) or last_s >= duration_s - LAST_S
    if not (first_s <= duration_s / 2 and stays):
        raise Failure(
            f'the frame {child} is not published all the time in the run with {run.scenario(scenario).words}',
            expected=f'the frame is published from {duration_s / 2:g} s at the latest until the end',
            seen=f'the frame is first published at {first_s:.2f} s, and last at {last_s:.2f} s',
            where=run.source.place,
            try_=try_,
        )


def _misspelt(child: str, frames: Iterable[str]) -> list[str]:
    """Return the frames whose names may be misspellings of `child`. For example, turtle1 is not a misspelling of turtle2."""
    return [name for name in frames if sub(r'\d+$', '', name) != sub(r'\d+$', '', child)]


def yaw(frame: Frame) -> float:
    """Return the rotation of a frame about the z axis of its parent, in radians."""
    x, y, z, w = frame.rotation
    return atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def tilt(frame: Frame) -> float:
    """Return the angle between the z axes of a frame and its parent, in radians."""
    x, y, _, _ = frame.rotation
    return 2 * asin(min(1.0, hypot(x, y)))


def place_in(frames: Frames, frame: str, root: str) -> tuple[float, float] | None:
    """Return the position of a frame's origin on the ground plane of `root`, in metres.

    Return None if no transforms connect the frames.
    """
    x = y = 0.0
    for _ in range(len(frames) + 1):
        if frame == root:
            return x, y
        link = frames.get(frame)
        if link is None:
            return None
        angle = yaw(link)
        x, y = (link.translation[0] + cos(angle) * x - sin(angle) * y, link.translation[1] + sin(angle) * x + cos(angle) * y)
        frame = link.parent
    return None


def numbers(values: tuple[float, ...]) -> str:
    """Return coordinates as a string such as '(1.00, 2.50)'."""
    return '(' + ', '.join(f'{value + 0.0:.2f}' for value in values) + ')'
