"""tf frames from above, as rviz2 shows them, as plain data: one view per tree of frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.composing import Placed, placed, rotated
from edulaunch.recording.absent import NothingToDraw

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording
    from edulaunch.recording.records import Frame


class FrameMark(NamedTuple):
    """A frame in its root: metres; where its x and y axes (1 long) point to when seen from above; its parent or ''."""

    name: str
    parent: str
    x: float
    y: float
    z: float
    x_axis: tuple[float, float]
    y_axis: tuple[float, float]
    is_static: bool


class View(NamedTuple):
    """A tree of frames: its root, its frames (the root first), and (left, right, bottom, top) in metres."""

    root: str
    frames: list[FrameMark]
    limits: tuple[float, float, float, float]


class FramesScene(NamedTuple):
    """All trees at one time."""

    time_s: float
    views: list[View]

    def caption(self) -> str:
        """One line that says what is to be seen."""
        views = [
            f'in {view.root}: '
            + ', '.join(f'{mark.name} at ({mark.x + 0.0:.3f}, {mark.y + 0.0:.3f})' for mark in view.frames[1:])
            for view in self.views
        ]
        return f't={self.time_s:.3f} s: {"; ".join(views)}'


def frames_scene(recording: Recording, time_s: float) -> FramesScene:
    """The frames that were known at a time.

    :raises ValueError: when none was; it says who was to broadcast.
    """
    frames = recording.frames_at(time_s)
    if not frames:
        raise NothingToDraw(f'no tf frame had been broadcast at t = {time_s:.3f} s; {_who(recording)}')
    trees: dict[str, list[FrameMark]] = {}
    for name, place in placed(frames).items():
        trees.setdefault(place.root, []).append(_mark(name, place, frames.get(name)))
    return FramesScene(
        round(time_s, 9), [View(root, _root_first(root, marks), limits_of(marks)) for root, marks in trees.items()]
    )


def _who(recording: Recording) -> str:
    nodes = [node for name in ('/tf_static', '/tf') if name in recording.topics for node in recording.topics[name].publishers]
    first = [time_s for name in ('/tf_static', '/tf') for time_s, _ in recording.messages(name)[:1]]
    when = f', the first of them at t = {min(first):.3f} s' if first else ', but none of them did'
    return f'broadcasters: {", ".join(dict.fromkeys(nodes))}{when}' if nodes else 'no node is a tf broadcaster'


def _mark(name: str, place: Placed, frame: Frame | None) -> FrameMark:
    axes = [rotated(place.turn, axis)[:2] for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))]
    parent = '' if frame is None or place.root == name else frame.parent
    return FrameMark(name, parent, *place.position, axes[0], axes[1], frame is not None and frame.is_static)


def _root_first(root: str, marks: list[FrameMark]) -> list[FrameMark]:
    return sorted(marks, key=lambda mark: mark.name != root)


def limits_of(marks: list[FrameMark]) -> tuple[float, float, float, float]:
    """A square with all frames in it and air around them, on a grid of half metres so that it stands still for a while."""
    xs, ys = [mark.x for mark in marks], [mark.y for mark in marks]
    side = max(max(xs) - min(xs), max(ys) - min(ys), 1.0) * 1.5
    x, y = (round((max(values) + min(values)) * 2) / 4 for values in (xs, ys))
    return (x - side / 2, x + side / 2, y - side / 2, y + side / 2)
