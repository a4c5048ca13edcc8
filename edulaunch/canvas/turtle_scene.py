"""What the turtle windows of a recording show at a time, as plain data."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from edulaunch.recording.trajectory import ODOMETRY, POSE, moving_things

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording

CANVAS_M = 11.088889
PEN = (179, 184, 255)
PEN_WIDTH = 3
BACKGROUND = (69, 86, 255)
Colour = tuple[int, int, int]


class Trail(NamedTuple):
    """A line that a pen drew: colour, width in pixels, points in metres."""

    colour: Colour
    width: int
    points: list[tuple[float, float]]


class Body(NamedTuple):
    """A turtle or robot: its name and where it is (metres, radians)."""

    name: str
    x: float
    y: float
    theta: float


class Window(NamedTuple):
    """One turtlesim window, or the field of one robot. `limits` is (left, right, bottom, top) in metres."""

    title: str
    kind: str
    background: Colour
    limits: tuple[float, float, float, float]
    bodies: list[Body]
    trails: list[Trail]


class TurtleScene(NamedTuple):
    """All windows at one time."""

    time_s: float
    windows: list[Window]

    def caption(self) -> str:
        """One line that says what is to be seen."""
        bodies = [f'{body.name} at ({body.x + 0.0:.3f}, {body.y + 0.0:.3f})' for window in self.windows for body in window.bodies]
        return f't={self.time_s:.3f} s: {", ".join(bodies)}'


def turtle_scene(recording: Recording, time_s: float) -> TurtleScene:
    """The scene of a recording at a time.

    :raises ValueError: when there was no turtle and no robot.
    """
    things = moving_things(recording)
    if not things:
        raise ValueError('nothing moved in this recording: no turtle pose and no odometry was published')
    windows: dict[str, list[tuple[str, str]]] = {}
    for name, topic in things.items():
        if recording.topics[topic].type == POSE:
            windows.setdefault(recording.topics[topic].publishers[0], []).append((name, topic))
    scenes = [_turtle_window(recording, node, turtles, time_s) for node, turtles in sorted(windows.items())]
    scenes += [_robot_field(recording, topic, time_s) for topic in things.values() if recording.topics[topic].type == ODOMETRY]
    return TurtleScene(round(time_s, 9), [scene for scene in scenes if scene is not None])


def _turtle_window(recording: Recording, node: str, turtles: list[tuple[str, str]], time_s: float) -> Window:
    parameters = recording.parameters(node)
    colour = [parameters[name].value if name in parameters else default
              for name, default in zip(('background_r', 'background_g', 'background_b'), BACKGROUND, strict=True)]
    bodies, trails = [], []
    wiped_s = _last_wipe(recording, node, time_s)
    for name, topic in turtles:
        rows = [row for row in recording.series(topic, 'x', 'y', 'theta') if row[0] <= time_s]
        if rows and time_s - rows[-1][0] < 0.1:
            bodies.append(Body(name.rpartition('/')[2], *rows[-1][1:]))
        trails += _trails(rows, _pens(recording, topic.removesuffix('/pose')), wiped_s)
    return Window(node, 'turtlesim', (colour[0], colour[1], colour[2]), (0.0, CANVAS_M, 0.0, CANVAS_M), bodies, trails)


def _last_wipe(recording: Recording, node: str, time_s: float) -> float:
    """When the window was last cleared or reset."""
    namespace = node.rpartition('/')[0]
    wipes = [call.time_s for call in recording.service_calls
             if call.service in (f'{namespace}/clear', f'{namespace}/reset') and call.time_s <= time_s]
    return max(wipes, default=-1.0)


def _pens(recording: Recording, turtle: str) -> list[tuple[float, Colour, int, bool]]:
    """The pen of a turtle over time: (from when, colour, width, whether it draws)."""
    pens: list[tuple[float, Colour, int, bool]] = [(-1.0, PEN, PEN_WIDTH, True)]
    for call in recording.service_calls:
        if call.service == f'{turtle}/set_pen' and call.served:
            ask = call.request
            pens.append((call.time_s, pens[-1][1], pens[-1][2], False) if ask.off else
                        (call.time_s, (ask.r, ask.g, ask.b), ask.width or 1, True))
    return pens


def _trails(rows: list[tuple[float, ...]], pens: list[tuple[float, Colour, int, bool]], wiped_s: float) -> list[Trail]:
    """The poses cut where the pen changed; points that a straight line covers are left out."""
    trails: list[Trail] = []
    for position, (start_s, colour, width, draws) in enumerate(pens):
        end_s = pens[position + 1][0] if position + 1 < len(pens) else float('inf')
        points = [(x, y) for t, x, y, _ in rows if max(start_s, wiped_s) <= t <= end_s]
        if draws and len(points) > 1 and len(set(points)) > 1:
            trails.append(Trail(colour, width, thinned(points)))
    return trails


def thinned(points: list[tuple[float, float]], tolerance_m: float = 0.002) -> list[tuple[float, float]]:
    """The same line with fewer points: a point stays when leaving it out would move the line by more than the tolerance."""
    kept = [points[0]]
    for before, point, after in zip(points, points[1:], points[2:], strict=False):
        (x0, y0), (x1, y1), (x2, y2) = kept[-1], point, after
        length = ((x2 - x0) ** 2 + (y2 - y0) ** 2) ** 0.5
        off = abs((x2 - x0) * (y1 - y0) - (y2 - y0) * (x1 - x0)) / length if length else ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5
        if off > tolerance_m or before == point:
            kept.append(point)
    return [*kept, points[-1]]


def _robot_field(recording: Recording, topic: str, time_s: float) -> Window | None:
    track = recording.trajectory(topic)
    rows = [(float(t), float(x), float(y), float(a)) for t, x, y, a in zip(*track, strict=True) if t <= time_s]
    if not rows:
        return None
    xs, ys = [row[1] for row in rows], [row[2] for row in rows]
    half = max(max(xs) - min(xs), max(ys) - min(ys), 1.0) * 0.6
    middle_x, middle_y = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2
    trail = thinned([row[1:3] for row in rows]) if len(set(zip(xs, ys, strict=True))) > 1 else []
    limits = (middle_x - half, middle_x + half, middle_y - half, middle_y + half)
    trails = [Trail((214, 95, 14), 2, trail)] if trail else []
    return Window(topic, 'robot', (255, 255, 255), limits, [Body('robot', *rows[-1][1:])], trails)
