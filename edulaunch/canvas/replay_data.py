"""A run as small plain data for the replay: whole numbers, sampled twenty times a second.

Lengths are in millimetres, angles in milliradians, times in samples. A *column* is a list whose first number is a value and
whose others are steps from the value before; steps of 0 at the end are left out.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from edulaunch.canvas.composing import heading, placed
from edulaunch.canvas.frame_tracks import FrameTracks
from edulaunch.canvas.worlds import GAP_S, START_S, Row, Track, World

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording

RATE_HZ = 20
JUMP_M = 0.5
"""A step further than this between two poses is a teleport: nothing is drawn in between."""
Sample = tuple[float, float, float]
"""x, y in metres and a heading in radians."""


def replay_data(recording: Recording, worlds: list[World]) -> dict[str, Any]:
    """What the player needs, ready for JSON."""
    count = math.floor(recording.duration_s * RATE_HZ + 1e-9) + 1
    data: dict[str, Any] = {'rate': RATE_HZ, 'samples': count, 'worlds': [_world(world, count) for world in worlds]}
    tracks = FrameTracks(recording)
    if tracks.names:
        _add_frames(data['worlds'], tracks, count)
    return data


def _world(world: World, count: int) -> dict[str, Any]:
    lives = [life for number, track in enumerate(world.tracks) for life in _lives(track, number, count)]
    return {
        'title': world.title,
        'kind': world.kind,
        'background': world.background,
        'limits': [_milli(limit) for limit in world.limits],
        'wipes': [math.ceil(wipe * RATE_HZ) for wipe in world.wipes],
        'lives': lives,
        'frame': world.frame,
        'frames': [],
    }


def _lives(track: Track, number: int, count: int) -> list[dict[str, Any]]:
    """The times without a gap in which a turtle was there, with its pens as [from sample, red, green, blue, width or 0]."""
    samples = _sampled(track.rows, count)
    pens = [[max(0, math.floor(pen.from_s * RATE_HZ)), *pen.colour, pen.width if pen.draws else 0] for pen in track.pens]
    return [
        {'name': track.name, 'number': number, 'first': first, **_columns(values), 'pens': pens}
        for first, values in _unbroken(samples)
    ]


def _unbroken(samples: list[Sample | None]) -> list[tuple[int, list[Sample]]]:
    """Stretches without None, with the number of their first sample."""
    found: list[tuple[int, list[Sample]]] = []
    for number, sample in enumerate(samples):
        if sample is not None:
            if number == 0 or samples[number - 1] is None:
                found.append((number, []))
            found[-1][1].append(sample)
    return found


def _sampled(rows: list[Row], count: int) -> list[Sample | None]:
    """Poses at the sampling times, between two messages in proportion; None where nobody was there."""
    found: list[Sample | None] = []
    position, last = 0, len(rows)
    for number in range(count):
        time_s = number / RATE_HZ
        while position < last and rows[position][0] <= time_s:
            position += 1
        found.append(_between(rows, position, time_s))
    return found


def _between(rows: list[Row], position: int, time_s: float) -> Sample | None:
    """The pose at a time that lies before rows[position]."""
    if not position and rows and rows[0][0] - time_s < START_S:
        return (rows[0][1], rows[0][2], rows[0][3])
    if not position or time_s - rows[position - 1][0] >= GAP_S:
        return None
    before_s, x, y, theta = rows[position - 1]
    if position < len(rows):
        after_s, x2, y2, theta2 = rows[position]
        if after_s - before_s < GAP_S and abs(x2 - x) + abs(y2 - y) < JUMP_M:
            part = (time_s - before_s) / (after_s - before_s)
            return (x + part * (x2 - x), y + part * (y2 - y), theta + part * math.remainder(theta2 - theta, math.tau))
    return (x, y, theta)


def _columns(values: list[Sample]) -> dict[str, Any]:
    """Columns x, y and a (heading, as a turn that goes on counting beyond a whole turn), and how many values they have."""
    headings = [values[0][2]]
    for before, after in zip(values, values[1:], strict=False):
        headings.append(headings[-1] + math.remainder(after[2] - before[2], math.tau))
    return {
        'count': len(values),
        'x': column([value[0] for value in values]),
        'y': column([value[1] for value in values]),
        'a': column(headings),
    }


def column(values: list[float]) -> list[int]:
    """The first value and the steps, in thousandths; zeros at the end are left out."""
    whole = [_milli(value) for value in values]
    steps = [whole[0], *(after - before for before, after in zip(whole, whole[1:], strict=False))]
    while len(steps) > 1 and not steps[-1]:
        steps.pop()
    return steps


def _milli(value: float) -> int:
    return round(value * 1000)


def _add_frames(worlds: list[dict[str, Any]], tracks: FrameTracks, count: int) -> None:
    """Frames in their root, each tree put into the world whose turtle it names, or in whose frame a robot says where it is.

    A tree that belongs to no world is left to `plot_frames`.
    """
    rows: dict[str, list[Sample | None]] = {}
    owner: dict[str, tuple[str, str]] = {}
    for number in range(count):
        frames = tracks.frames_at(number / RATE_HZ)
        for name, place in placed(frames).items():
            yaw = heading(place.turn)
            rows.setdefault(name, [None] * number).append((place.position[0], place.position[1], yaw))
            owner[name] = (place.root, frames[name].parent if name in frames else '')
    for name, samples in rows.items():
        root, parent = owner[name]
        tree = {other for other, (top, _) in owner.items() if top == root}
        world = next((world for world in worlds if {world['frame'], *(life['name'] for life in world['lives'])} & tree), None)
        if world is not None:
            world['frames'] += [
                {'name': name, 'parent': parent, 'first': first, **_columns(values)}
                for first, values in _unbroken(samples + [None] * (count - len(samples)))
            ]


def pose_at(life: dict[str, Any], sample: int) -> tuple[float, float, float] | None:
    """Where a life (or frame) is at a sample, in metres and radians: the player's own reading of columns."""
    number = sample - life['first']
    if not 0 <= number < life['count']:
        return None
    x, y, a = (sum(life[key][: number + 1]) / 1000 for key in 'xya')
    return (x, y, a)
