"""tf frames from above or from a side, as rviz2 shows them, as plain data: one view per tree of frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.composing import Placed, placed, rotated
from edulaunch.nearest import did_you_mean
from edulaunch.recording.absent import NothingToDraw

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording
    from edulaunch.recording.records import Frame

SIDES = {'xy': (0, 1, 2), 'xz': (0, 2, 1), 'yz': (1, 2, 0)}
"""Which of the root's axes go across the sheet, up, and towards who looks."""


class FrameMark(NamedTuple):
    """A frame in its root: metres; its parent or ''; where its axes (1 long) point to on the sheet.

    `x` and `y` are across and up the sheet, `z` towards who looks: from above these are the root's x, y and z.
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
    """A tree of frames: its root, its frames (the root first), and (left, right, bottom, top) in metres."""

    root: str
    frames: list[FrameMark]
    limits: tuple[float, float, float, float]


class FramesScene(NamedTuple):
    """All trees at one time; `side` names the axes of the root that go across and up the sheet."""

    time_s: float
    views: list[View]
    side: str = 'xy'

    def caption(self) -> str:
        """One line that says what is to be seen."""
        views = [
            f'in {view.root}: '
            + ', '.join(f'{mark.name} at ({mark.x + 0.0:.3f}, {mark.y + 0.0:.3f})' for mark in view.frames[1:])
            for view in self.views
        ]
        seen = '' if self.side == 'xy' else f'seen from the side, {self.side[0]} and {self.side[1]}: '
        return f't={self.time_s:.3f} s: {seen}{"; ".join(views)}'


def frames_scene(recording: Recording, time_s: float, side: str = 'xy') -> FramesScene:
    """The frames that were known at a time.

    :param side: 'xy' from above, 'xz' or 'yz' from a side: which axes go across and up.
    :raises ValueError: when none was, it says who was to broadcast; or for another side.
    """
    if side not in SIDES:
        raise NothingToDraw(f'there is no side {side!r}', help=did_you_mean(side, SIDES) or f'one of {", ".join(SIDES)}')
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
    """A frame as it is seen from a side."""
    across, up, towards = SIDES[side]
    turned = (rotated(place.turn, axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
    x_axis, y_axis, z_axis = ((axis[across], axis[up]) for axis in turned)
    parent = '' if frame is None or place.root == name else frame.parent
    position = (place.position[across], place.position[up], place.position[towards])
    return FrameMark(name, parent, *position, x_axis, y_axis, frame is not None and frame.is_static, z_axis)


def _root_first(root: str, marks: list[FrameMark]) -> list[FrameMark]:
    return sorted(marks, key=lambda mark: mark.name != root)


def limits_of(marks: list[FrameMark]) -> tuple[float, float, float, float]:
    """A square with all frames in it and air around them, on a grid of half metres so that it stands still for a while."""
    xs, ys = [mark.x for mark in marks], [mark.y for mark in marks]
    side = max(max(xs) - min(xs), max(ys) - min(ys), 1.0) * 1.5
    x, y = (round((max(values) + min(values)) * 2) / 4 for values in (xs, ys))
    return (x - side / 2, x + side / 2, y - side / 2, y + side / 2)
