"""The moving objects of a recording: turtle windows and robots, with their poses, their pens and the times of clearing."""

from __future__ import annotations

import math
from bisect import bisect_right
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.frames_scene import Placed, heading, placed
from edulaunch.canvas.outlines import FOOTPRINTS, Part, outline_of, outline_of_footprint
from edulaunch.canvas.style import Colour
from edulaunch.engine.recording.absent import NothingToDraw
from edulaunch.engine.recording.trajectory import ODOMETRY, POSE, moving_things

if TYPE_CHECKING:
    from edulaunch.engine.recording.recording import Recording

CANVAS_M = 11.088889
PEN: Colour = (179, 184, 255)
PEN_WIDTH = 3
ROBOT_TRAIL: Colour = (196, 78, 10)
BACKGROUND = (69, 86, 255)
GAP_S = 0.1
"""A turtle without a pose for this many seconds no longer exists."""
START_S = 0.05
"""A turtle is assumed to exist this long before its first pose."""

Row = tuple[float, ...]


class Pen(NamedTuple):
    """The state of a turtle's pen from a time on: its colour, its width in pixels of a turtlesim window, and whether it draws."""

    from_s: float
    colour: Colour
    width: int
    draws: bool


class Track(NamedTuple):
    """A turtle or robot: rows (time in seconds, x, y in metres, heading in radians), and its pens in order of time.

    `outline` is the shape of a robot from above, if the robot publishes one; see :mod:`edulaunch.canvas.outlines`.
    """

    name: str
    rows: list[Row]
    pens: list[Pen]
    outline: list[Part] = []

    def row_at(self, time_s: float) -> Row | None:
        """Return the pose at a time, or None if the object did not exist then. The first pose is also used for up to `START_S`
        seconds before it.
        """
        position = bisect_right(self.rows, time_s, key=itemgetter(0))
        if not position and self.rows and self.rows[0][0] - time_s < START_S:
            return self.rows[0]
        return self.rows[position - 1] if position and time_s - self.rows[position - 1][0] < GAP_S else None


class World(NamedTuple):
    """One turtlesim window, or the field of the robots that share an odometry frame or a static ancestor of their odometry
    frames.

    `kind` is 'turtlesim' or 'robot'. `limits` is (left, right, bottom, top) in metres. `wipes` are the times when the canvas was
    cleared. `frame` is the tf frame of the field, or '' for turtles, whose messages have no frame.
    """

    title: str
    kind: str
    background: Colour
    limits: tuple[float, float, float, float]
    wipes: list[float]
    tracks: list[Track]
    frame: str


def read_worlds(recording: Recording) -> list[World]:
    """Return the worlds of a recording, turtle windows first.

    :raises ValueError: when the recording contains no turtle and no robot.
    """
    things = moving_things(recording)
    if not things:
        raise NothingToDraw('nothing moved in this recording: no turtle pose and no odometry was published')
    windows: dict[str, list[tuple[str, str]]] = {}
    for name, topic in things.items():
        if recording.topics[topic].type == POSE:
            windows.setdefault(recording.topics[topic].publishers[0], []).append((name, topic))
    worlds = [_turtle_window(recording, node, turtles) for node, turtles in sorted(windows.items())]
    return worlds + _robot_fields(recording, [topic for topic in things.values() if recording.topics[topic].type == ODOMETRY])


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
    """Return the times when the window was cleared or reset."""
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


def _robot_fields(recording: Recording, topics: list[str]) -> list[World]:
    """Return the fields of the robots. Robots whose odometry frames have a common static ancestor share one field.

    A field always covers the whole path of its robots, so that pictures of different times can be compared.
    """
    if not topics:
        return []
    frames = recording.frames_at(recording.duration_s)
    still = placed({name: frame for name, frame in frames.items() if frame.is_static})
    groups: dict[str, list[tuple[str, str]]] = {}
    for topic in topics:
        for _, message in recording.messages(topic)[:1]:
            frame = message.header.frame_id
            groups.setdefault(still[frame].root if frame in still else frame, []).append((topic, frame))
    return [_field(recording, root, robots, still) for root, robots in groups.items()]


def _field(recording: Recording, root: str, robots: list[tuple[str, str]], still: dict[str, Placed]) -> World:
    """Return the field of one robot in its odometry frame, or of several robots in their root frame."""
    alone, tracks = len(robots) == 1, []
    for topic, frame in robots:
        namespace = topic.rpartition('/')[0]
        rows: list[Row] = [tuple(map(float, row)) for row in zip(*recording.trajectory(topic), strict=True)]
        if not alone and frame in still:
            rows = [_moved(row, still[frame]) for row in rows]
        name = 'robot' if alone or not namespace else namespace.removeprefix('/')
        tracks.append(Track(name, rows, [Pen(-1.0, ROBOT_TRAIL, 3, True)], _outline(recording, namespace)))
    xs, ys = ([row[axis] for track in tracks for row in track.rows] for axis in (1, 2))
    reach = max((math.hypot(*corner) for track in tracks for part in track.outline for corner in part.corners), default=0.0)
    half = max(max(xs) - min(xs), max(ys) - min(ys), 1.0) * 0.6 + reach
    x, y = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2
    title, frame = robots[0] if alone else (f'robots in {root}', root)
    return World(title, 'robot', (255, 255, 255), (x - half, x + half, y - half, y + half), [], tracks, frame)


def _moved(row: Row, place: Placed) -> Row:
    """Convert a pose in a frame to a pose in the frame's root."""
    time, x, y, angle = row
    turn = heading(place.turn)
    c, s = math.cos(turn), math.sin(turn)
    return (time, place.position[0] + c * x - s * y, place.position[1] + s * x + c * y, angle + turn)


def _outline(recording: Recording, namespace: str) -> list[Part]:
    """Return the outline of a robot. It comes from the robot description of a namespace or its nearest parent, or else from the
    footprint of a node in the namespace.
    """
    named = {name.removesuffix('/robot_description'): name for name in recording.topics if name.endswith('/robot_description')}
    for above in sorted(named, key=len, reverse=True):
        texts = [getattr(message, 'data', '') for _, message in recording.messages(named[above])]
        if texts and f'{namespace}/'.startswith(f'{above}/'):
            return outline_of(texts[-1])
    for node in recording.nodes:
        if node.name.startswith(f'{namespace}/'):
            known = recording.parameters(node.name)
            for name in FOOTPRINTS:
                if name in known and (found := outline_of_footprint(str(known[name].value))):
                    return found
    return []
