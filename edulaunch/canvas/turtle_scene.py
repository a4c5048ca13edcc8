"""The turtle windows of a recording at one time as plain data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.frames_scene import FrameMark, mark_of, placed, seen_from
from edulaunch.canvas.outlines import Part
from edulaunch.canvas.series_scene import thinned
from edulaunch.canvas.style import SHELLS, Colour
from edulaunch.canvas.worlds import GAP_S, Pen, Row, Track, World
from edulaunch.engine.recording.absent import not_recorded

if TYPE_CHECKING:
    from edulaunch.engine.recording.records import Frame

FINENESS = 5000
"""The tolerance of trails, as a fraction of the window's width. It is well below an image pixel."""


class Trail(NamedTuple):
    """A line that a pen has drawn: its colour, its width in pixels of a turtlesim window, and its points in metres."""

    colour: Colour
    width: int
    points: list[tuple[float, float]]


class Body(NamedTuple):
    """A turtle or robot: its name, its pose (metres, radians), the number of its track in the window, and a robot's outline."""

    name: str
    x: float
    y: float
    theta: float
    number: int
    outline: list[Part] = []


class Window(NamedTuple):
    """One turtlesim window, or the field of one robot. `limits` is (left, right, bottom, top) in metres."""

    title: str
    kind: str
    background: Colour
    limits: tuple[float, float, float, float]
    bodies: list[Body]
    trails: list[Trail]
    frames: list[FrameMark] = []


class TurtleScene(NamedTuple):
    """All windows at one time."""

    time_s: float
    windows: list[Window]

    def caption(self) -> str:
        """Return one line that describes the scene."""
        several = len(self.windows) > 1
        bodies = [
            f'{window.title + ": " if several else ""}{body.name} at ({body.x + 0.0:.3f}, {body.y + 0.0:.3f})'
            for window in self.windows
            for body in window.bodies
        ]
        return f't={self.time_s:.3f} s: {", ".join(bodies) or "empty"}'


def turtle_scene(
    worlds: list[World],
    time_s: float,
    *,
    colours: bool = True,
    frames: Mapping[str, Frame] | None = None,
    only: Sequence[str] | None = None,
) -> TurtleScene:
    """Return the scene with all worlds at one time.

    :param colours: whether to draw each trail in a separate colour, unless a program has set the pen.
    :param frames: the tf frames to draw on top, if any.
    :param only: the names of the frames to draw; None means all frames.
    :raises NotRecorded: for an unknown frame.
    """
    windows = [_window(world, time_s, colours and len(world.tracks) > 1) for world in worlds]
    if frames:
        known = placed(dict(frames))
        for name in only or ():
            if name not in known:
                raise not_recorded(f'no frame {name!r}', name, known)
        windows = [window._replace(frames=_marks(world, frames, only)) for world, window in zip(worlds, windows, strict=True)]
    return TurtleScene(round(time_s, 9), windows)


def _marks(world: World, frames: Mapping[str, Frame], only: Sequence[str] | None) -> list[FrameMark]:
    """Return the frames that are connected to a world, relative to the world's frame."""
    places = placed(dict(frames))
    fixed = world.frame or 'world'
    own = {track.name for track in world.tracks}
    if fixed not in places or (world.kind == 'turtlesim' and not own & places.keys()):
        return []
    marks = []
    for name, place in places.items():
        if name != fixed and place.root == places[fixed].root and (only is None or name in only):
            marks.append(mark_of(name, seen_from(places[fixed], place), frames.get(name)))
    return marks


def _window(world: World, time_s: float, colours: bool) -> Window:
    wiped_s = max((wipe for wipe in world.wipes if wipe <= time_s), default=-1.0)
    bodies, trails = [], []
    for number, track in enumerate(world.tracks):
        row = track.row_at(time_s)
        if row is not None:
            bodies.append(Body(track.name, row[1], row[2], row[3], number, track.outline))
        own = (
            track
            if not colours or len(track.pens) > 1
            else track._replace(pens=[track.pens[0]._replace(colour=SHELLS[number % len(SHELLS)])])
        )
        trails += trails_of(own, wiped_s, time_s, (world.limits[1] - world.limits[0]) / FINENESS)
    return Window(world.title, world.kind, world.background, world.limits, bodies, trails)


def trails_of(track: Track, from_s: float, until_s: float, tolerance_m: float) -> list[Trail]:
    """Return the lines of a track between two times. A new line begins where the pen changed or the turtle did not exist."""
    trails: list[Trail] = []
    ends = [*(pen.from_s for pen in track.pens[1:]), float('inf')]
    for pen, end_s in zip(track.pens, ends, strict=True):
        if pen.draws:
            rows = [row for row in track.rows if max(pen.from_s, from_s) <= row[0] <= min(end_s, until_s)]
            trails += [_trail(pen, stretch, tolerance_m) for stretch in _stretches(rows)]
    return [trail for trail in trails if len(trail.points) > 1]


def _stretches(rows: list[Row]) -> list[list[Row]]:
    """Split the rows wherever there is a gap in time."""
    cuts = [0, *(number for number in range(1, len(rows)) if rows[number][0] - rows[number - 1][0] > GAP_S), len(rows)]
    return [rows[start:end] for start, end in zip(cuts, cuts[1:], strict=False) if end > start]


def _trail(pen: Pen, rows: list[Row], tolerance_m: float) -> Trail:
    points = thinned([(row[1], row[2]) for row in rows], tolerance_m)
    return Trail(pen.colour, pen.width, points if len(set(points)) > 1 else points[:1])
