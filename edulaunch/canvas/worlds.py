"""What moved in a recording: turtle windows and robots, with their poses, pens and wiped canvases over time."""

from __future__ import annotations

from bisect import bisect_right
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.style import Colour
from edulaunch.recording.absent import NothingToDraw
from edulaunch.recording.trajectory import ODOMETRY, POSE, moving_things

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording

CANVAS_M = 11.088889
PEN: Colour = (179, 184, 255)
PEN_WIDTH = 3
ROBOT_TRAIL: Colour = (196, 78, 10)
BACKGROUND = (69, 86, 255)
GAP_S = 0.1
"""A turtle whose pose is not published for so long is no longer there."""
START_S = 0.05
"""How long before its first pose a turtle is taken to be there."""

Row = tuple[float, ...]


class Pen(NamedTuple):
    """How a turtle draws from a time on: colour, width in pixels of a turtlesim window, and whether it draws at all."""

    from_s: float
    colour: Colour
    width: int
    draws: bool


class Track(NamedTuple):
    """A turtle or robot: rows of (time in seconds, x, y in metres, heading in radians), and its pens in order of time."""

    name: str
    rows: list[Row]
    pens: list[Pen]

    def row_at(self, time_s: float) -> Row | None:
        """Where it was; None when it was not there. The first pose stands for the moment before it too."""
        position = bisect_right(self.rows, time_s, key=itemgetter(0))
        if not position and self.rows and self.rows[0][0] - time_s < START_S:
            return self.rows[0]
        return self.rows[position - 1] if position and time_s - self.rows[position - 1][0] < GAP_S else None


class World(NamedTuple):
    """One turtlesim window, or the field of one robot.

    `kind` is 'turtlesim' or 'robot'; `limits` is (left, right, bottom, top) in metres; `wipes` are the times when the canvas was
    cleared; `frame` is the tf frame in which a robot says where it is ('' for turtles, which do not say).
    """

    title: str
    kind: str
    background: Colour
    limits: tuple[float, float, float, float]
    wipes: list[float]
    tracks: list[Track]
    frame: str


def read_worlds(recording: Recording) -> list[World]:
    """The worlds of a recording, turtle windows first.

    :raises ValueError: when there was no turtle and no robot.
    """
    things = moving_things(recording)
    if not things:
        raise NothingToDraw('nothing moved in this recording: no turtle pose and no odometry was published')
    windows: dict[str, list[tuple[str, str]]] = {}
    for name, topic in things.items():
        if recording.topics[topic].type == POSE:
            windows.setdefault(recording.topics[topic].publishers[0], []).append((name, topic))
    worlds = [_turtle_window(recording, node, turtles) for node, turtles in sorted(windows.items())]
    fields = [_robot_field(recording, topic) for topic in things.values() if recording.topics[topic].type == ODOMETRY]
    return worlds + [field for field in fields if field is not None]


def _turtle_window(recording: Recording, node: str, turtles: list[tuple[str, str]]) -> World:
    parameters = recording.parameters(node)
    red, green, blue = (
        int(parameters[name].value) if name in parameters else default
        for name, default in zip(('background_r', 'background_g', 'background_b'), BACKGROUND, strict=True)
    )
    tracks = [
        Track(name.rpartition('/')[2], recording.series(topic, 'x', 'y', 'theta'), _pens(recording, topic.removesuffix('/pose')))
        for name, topic in turtles
    ]
    return World(node, 'turtlesim', (red, green, blue), (0.0, CANVAS_M, 0.0, CANVAS_M), _wipes(recording, node), tracks, '')


def _wipes(recording: Recording, node: str) -> list[float]:
    """When the window was cleared or reset."""
    namespace = node.rpartition('/')[0]
    return [
        call.time_s
        for call in recording.service_calls
        if call.served and call.service in (f'{namespace}/clear', f'{namespace}/reset')
    ]


def _pens(recording: Recording, turtle: str) -> list[Pen]:
    pens = [Pen(-1.0, PEN, PEN_WIDTH, True)]
    for call in recording.service_calls:
        if call.service == f'{turtle}/set_pen' and call.served:
            ask = call.request
            colour, width = (pens[-1].colour, pens[-1].width) if ask.off else ((ask.r, ask.g, ask.b), ask.width or 1)
            pens.append(Pen(call.time_s, colour, width, not ask.off))
    return pens


def _robot_field(recording: Recording, topic: str) -> World | None:
    """The field of a robot shows its whole way at any time, so that pictures of different times compare."""
    track = recording.trajectory(topic)
    rows: list[Row] = [(float(t), float(x), float(y), float(a)) for t, x, y, a in zip(*track, strict=True)]
    if not rows:
        return None
    xs, ys = [row[1] for row in rows], [row[2] for row in rows]
    half = max(max(xs) - min(xs), max(ys) - min(ys), 1.0) * 0.6
    x, y = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2
    pens = [Pen(-1.0, ROBOT_TRAIL, 3, True)]
    frame = recording.messages(topic)[0][1].header.frame_id
    return World(
        topic, 'robot', (255, 255, 255), (x - half, x + half, y - half, y + half), [], [Track('robot', rows, pens)], frame
    )
