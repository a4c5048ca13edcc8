"""Plain data of lines over time: the numbers of a topic, and the distance between two objects. Lines can be simplified."""

from __future__ import annotations

import math
from bisect import bisect_right
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.canvas.frames_scene import FrameTracks, placed
from edulaunch.canvas.worlds import GAP_S
from edulaunch.engine.recording.absent import NothingToDraw, not_recorded
from edulaunch.engine.recording.trajectory import moving_things

if TYPE_CHECKING:
    from edulaunch.engine.recording.recording import Recording

Place = tuple[float, float, float]
"""A position: the time in seconds, and x and y in metres."""
Point = tuple[float, float]


class SeriesScene(NamedTuple):
    """Lines by field name. A line is a list of points (time in seconds, value)."""

    topic: str
    duration_s: float
    lines: list[tuple[str, list[tuple[float, float]]]]

    def caption(self) -> str:
        """Return one line that describes the scene."""
        ranges = (f'{field} from {points[0][1]:.3f} to {points[-1][1]:.3f}' for field, points in self.lines)
        return f'{self.topic}: {", ".join(ranges)}'


def series_scene(recording: Recording, topic: str, fields: tuple[str, ...]) -> SeriesScene:
    """Return the scene with fields of a topic over time.

    :raises NotRecorded: for an unknown topic or field; the message contains the most similar name.
    :raises NothingToDraw: when the topic has no messages, or a field is not a number.
    """
    if topic not in recording.topics:
        raise not_recorded(f'no topic {topic!r}', topic, recording.topics)
    rows = recording.series(topic, *fields)
    if not rows:
        raise NothingToDraw(f'nothing was published on {topic}')
    for field, value in zip(fields, rows[0][1:], strict=True):
        if not isinstance(value, (int, float)):
            raise NothingToDraw(f'cannot plot {field!r} of {topic}: it is a {type(value).__name__}, not a number')
    lines = [(field, [(row[0], float(row[place])) for row in rows]) for place, field in enumerate(fields, 1)]
    return SeriesScene(topic, recording.duration_s, lines)


class DistanceScene(NamedTuple):
    """Points (time, distance), the largest distance that counts as close, in metres, and `close_since_s`.

    `close_since_s` is the time since which the distance has stayed close until the end; None if it is not close at the end.
    """

    first: str
    second: str
    close_m: float
    duration_s: float
    points: list[tuple[float, float]]
    close_since_s: float | None

    def caption(self) -> str:
        """Return one line that describes the scene."""
        since = 'not close at the end'
        if self.close_since_s is not None:
            since = f'at most {self.close_m:g} m from t={self.close_since_s:.2f} s on'
        return (
            f'{self.first} to {self.second}: {self.points[0][1]:.3f} m at t={self.points[0][0]:.2f} s, '
            f'{self.points[-1][1]:.3f} m at t={self.points[-1][0]:.2f} s, {since}'
        )


def distance_scene(recording: Recording, first: str, second: str, close_m: float) -> DistanceScene:
    """Return the scene with the distance at each movement of the first object, while both objects existed.

    :raises KeyError: when a name is not a turtle, a robot or a tf frame of the recording.
    :raises ValueError: when the two objects did not exist at the same time.
    """
    others = places_of(recording, second)
    points = []
    for time_s, x, y in places_of(recording, first):
        position = bisect_right(others, time_s, key=itemgetter(0))
        if position and time_s - others[position - 1][0] < GAP_S:
            points.append((time_s, math.hypot(x - others[position - 1][1], y - others[position - 1][2])))
    if not points:
        raise NothingToDraw(f'{first!r} and {second!r} did not exist at the same time')
    return DistanceScene(first, second, close_m, recording.duration_s, points, _close_since(points, close_m))


def _close_since(points: list[tuple[float, float]], close_m: float) -> float | None:
    since = None
    for time_s, distance in points:
        since = None if distance > close_m else time_s if since is None else since
    return since


def places_of(recording: Recording, name: str) -> list[Place]:
    """Return (time in s, x in m, y in m) for each position of an object that moved, in order of time.

    :param name: a turtle or a robot, whose positions are in its world. Otherwise a tf frame, whose positions are in its root
        frame, twenty times a second.
    :raises NotRecorded: when no object of this name moved. The error contains the most similar name.
    """
    things = moving_things(recording)
    if name in things or '/' + name in things or name.removeprefix('/') in things:
        track = recording.trajectory(name)
        return [(float(t), float(x), float(y)) for t, x, y in zip(track.t, track.x, track.y, strict=True)]
    frames = placed(recording.frames_at(recording.duration_s))
    if name not in frames:
        raise not_recorded(f'nothing called {name!r} moved', name, [*things, *frames])
    return _frame_places(recording, name)


def _frame_places(recording: Recording, name: str) -> list[Place]:
    """Return the positions of a frame in its root frame, twenty times a second."""
    tracks = FrameTracks(recording)
    times = [number / 20 for number in range(math.floor(recording.duration_s * 20 + 1e-9) + 1)]
    found = [(time_s, tracks.placed_at(time_s).get(name)) for time_s in times]
    return [(time_s, place.position[0], place.position[1]) for time_s, place in found if place is not None]


def thinned(points: list[Point], tolerance_m: float = 0.002) -> list[Point]:
    """Return a line with fewer points. No removed point is further than the tolerance from the remaining line.

    Seen from the last remaining point, each further point allows a cone of directions. A segment can continue while its cones
    share a direction and the line does not turn back.
    """
    kept = [points[0]]
    (x0, y0), low, high, reach, axis = points[0], -math.inf, math.inf, 0.0, 0.0
    for before, (x, y) in zip(points, points[1:], strict=False):
        if before == (x, y):
            continue  # repeated points are common, and do not change the line
        distance = math.hypot(x - x0, y - y0)
        if distance > tolerance_m or reach > tolerance_m:
            turn = math.remainder(math.atan2(y - y0, x - x0) - axis, math.tau) if reach else 0.0
            if not (low <= turn <= high and distance >= reach):
                kept.append(before)
                (x0, y0), low, high, reach = before, -math.inf, math.inf, 0.0
                distance = math.hypot(x - x0, y - y0)
                turn = 0.0
            if not reach and distance > tolerance_m:
                axis = math.atan2(y - y0, x - x0)
            if distance > tolerance_m:
                half = math.asin(tolerance_m / distance)
                low, high, reach = max(low, turn - half), min(high, turn + half), distance
    return [*kept, points[-1]]
