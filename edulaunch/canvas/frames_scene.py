"""The tf frames at any time as plain data, in the root frame of their tree, from above or from a side."""

from __future__ import annotations

import math
from bisect import bisect_right
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.engine.nearest import did_you_mean
from edulaunch.engine.recording.absent import NothingToDraw
from edulaunch.engine.recording.frames import TOPICS, transform_wires
from edulaunch.engine.recording.records import Frame
from edulaunch.engine.tf.quaternions import Quaternion, Vector, conjugate, multiply, rotate

if TYPE_CHECKING:
    from edulaunch.engine.recording.recording import Recording

AT_HOME = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))
SIDES = {'xy': (0, 1, 2), 'xz': (0, 2, 1), 'yz': (1, 2, 0)}
"""The axes of the root that point right, up, and towards the viewer."""


class Placed(NamedTuple):
    """The pose of a frame in the root of its tree: the position in metres, and the rotation as (x, y, z, w)."""

    root: str
    position: Vector
    turn: Quaternion


def placed(frames: dict[str, Frame]) -> dict[str, Placed]:
    """Return the pose of every frame in its root frame, also for frames that appear only as parents. Roots come first, in order
    of appearance.

    A loop of parents has no root, so its first frame is used as the root.
    """
    found: dict[str, Placed] = {}
    for name in dict.fromkeys([*(frame.parent for frame in frames.values()), *frames]):
        _place(name, frames, found, [])
    return found


def _place(name: str, frames: dict[str, Frame], found: dict[str, Placed], way: list[str]) -> Placed:
    if name not in found:
        frame = frames.get(name)
        if frame is None or frame.parent in (*way, name):
            found[name] = Placed(name, *AT_HOME)
        else:
            parent = _place(frame.parent, frames, found, [*way, name])
            if name not in found:  # a loop may have made it a root in the meantime
                found[name] = Placed(
                    parent.root,
                    _add(parent.position, rotate(parent.turn, frame.translation)),
                    multiply(parent.turn, frame.rotation),
                )
    return found[name]


def seen_from(fixed: Placed, place: Placed) -> Placed:
    """Return the pose of the frame `place` relative to the frame `fixed`, in metres and as a unit quaternion.

    :param fixed: the pose of the frame to which the result refers.
    :param place: the pose to convert, in the same root frame as `fixed`.
    """
    back = conjugate(fixed.turn)
    a, b = place.position, fixed.position
    return Placed(place.root, rotate(back, (a[0] - b[0], a[1] - b[1], a[2] - b[2])), multiply(back, place.turn))


def heading(turn: Quaternion) -> float:
    """Return the direction of the rotated x axis from above, in radians."""
    x, y, z, w = turn
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def _add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


class FrameMark(NamedTuple):
    """A frame in its root frame: the position in metres, the parent or '', and the directions of its axes on the sheet.

    `x` and `y` point right and up on the sheet, and `z` points towards the viewer. Each axis has the length 1. From above,
    these are the root's x, y and z.
    """

    name: str
    parent: str
    x: float
    y: float
    z: float
    x_axis: tuple[float, float]
    y_axis: tuple[float, float]
    is_static: bool
    z_axis: tuple[float, float] = (0.0, 0.0)


class View(NamedTuple):
    """A tree of frames: its root, its frames (root first), and its limits (left, right, bottom, top) in metres."""

    root: str
    frames: list[FrameMark]
    limits: tuple[float, float, float, float]


class FramesScene(NamedTuple):
    """All trees at one time. `side` names the axes of the root that point right and up."""

    time_s: float
    views: list[View]
    side: str = 'xy'

    def caption(self) -> str:
        """Return one line that describes the scene."""
        views = [
            f'in {view.root}: '
            + ', '.join(f'{mark.name} at ({mark.x + 0.0:.3f}, {mark.y + 0.0:.3f})' for mark in view.frames[1:])
            for view in self.views
        ]
        seen = '' if self.side == 'xy' else f'seen from the side, {self.side[0]} and {self.side[1]}: '
        return f't={self.time_s:.3f} s: {seen}{"; ".join(views)}'


def frames_scene(recording: Recording, time_s: float, side: str = 'xy') -> FramesScene:
    """Return the scene of all frames that were known at a time.

    :param side: the axes that point right and up: 'xy' from above, 'xz' or 'yz' from a side.
    :raises ValueError: for another side, or when there was no frame. If there was no frame, the message names the
        broadcasters.
    """
    if side not in SIDES:
        raise NothingToDraw(f'unknown side {side!r}', help=did_you_mean(side, SIDES) or f'choose one of {", ".join(SIDES)}')
    frames = recording.frames_at(time_s)
    if not frames:
        raise NothingToDraw(f'no tf frame had been broadcast at t = {time_s:.3f} s; {_who(recording)}')
    trees: dict[str, list[FrameMark]] = {}
    for name, place in placed(frames).items():
        trees.setdefault(place.root, []).append(mark_of(name, place, frames.get(name), side))
    return FramesScene(
        round(time_s, 9), [View(root, _root_first(root, marks), limits_of(marks)) for root, marks in trees.items()], side
    )


def _who(recording: Recording) -> str:
    nodes = [node for name in ('/tf_static', '/tf') if name in recording.topics for node in recording.topics[name].publishers]
    first = [time_s for name in ('/tf_static', '/tf') for time_s, _ in recording.messages(name)[:1]]
    when = f', the first of them at t = {min(first):.3f} s' if first else ', but none of them did'
    return f'broadcasters: {", ".join(dict.fromkeys(nodes))}{when}' if nodes else 'no node is a tf broadcaster'


def mark_of(name: str, place: Placed, frame: Frame | None, side: str = 'xy') -> FrameMark:
    """Return a frame as it appears from a side."""
    across, up, towards = SIDES[side]
    turned = (rotate(place.turn, axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
    x_axis, y_axis, z_axis = ((axis[across], axis[up]) for axis in turned)
    parent = '' if frame is None or place.root == name else frame.parent
    position = (place.position[across], place.position[up], place.position[towards])
    return FrameMark(name, parent, *position, x_axis, y_axis, frame is not None and frame.is_static, z_axis)


def _root_first(root: str, marks: list[FrameMark]) -> list[FrameMark]:
    return sorted(marks, key=lambda mark: mark.name != root)


def limits_of(marks: list[FrameMark]) -> tuple[float, float, float, float]:
    """Return a square around all frames with a margin. Its edges are multiples of half a metre, so that the square rarely
    changes.
    """
    xs, ys = [mark.x for mark in marks], [mark.y for mark in marks]
    side = max(max(xs) - min(xs), max(ys) - min(ys), 1.0) * 1.5
    x, y = (round((max(values) + min(values)) * 2) / 4 for values in (xs, ys))
    return (x - side / 2, x + side / 2, y - side / 2, y + side / 2)


class FrameTracks:
    """All transforms of a recording by child frame, in order of publication.

    As in tf2, a static transform replaces earlier transforms. Among dynamic transforms, the newest transform is used.
    """

    def __init__(self, recording: Recording) -> None:
        self._rows: dict[str, list[tuple[float, Frame]]] = {}
        for topic, is_static in TOPICS:
            for published_s, (_, _, parent, child, x, y, z, qx, qy, qz, qw) in transform_wires(recording, topic):
                frame = Frame(parent, (x, y, z), (qx, qy, qz, qw), is_static, published_s)
                self._rows.setdefault(child, []).append((published_s, frame))

    def frames_at(self, time_s: float) -> dict[str, Frame]:
        """Return the newest transform of each child frame at a time."""
        found = {}
        for name, rows in self._rows.items():
            position = bisect_right(rows, time_s, key=itemgetter(0))
            if position:
                found[name] = rows[position - 1][1]
        return found

    def placed_at(self, time_s: float) -> dict[str, Placed]:
        """Return the pose of every frame in its root frame at a time."""
        return placed(self.frames_at(time_s))
