"""tf frames put where they are in their tree's root frame."""

from __future__ import annotations

import math
from typing import NamedTuple

from edulaunch.recording.records import Frame

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]


class Placed(NamedTuple):
    """Where a frame is in the root of its tree: metres, and its turn as (x, y, z, w)."""

    root: str
    position: Vector
    turn: Quaternion


AT_HOME = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def placed(frames: dict[str, Frame]) -> dict[str, Placed]:
    """Every frame, parents included, in its root frame; roots first as they appear.

    A loop of parents has no root: its frame that is met first stands for one.
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
            if name not in found:  # a loop may have made it a root meanwhile
                found[name] = Placed(
                    parent.root,
                    _add(parent.position, rotated(parent.turn, frame.translation)),
                    multiplied(parent.turn, frame.rotation),
                )
    return found[name]


def seen_from(fixed: Placed, place: Placed) -> Placed:
    """A frame as another one of its tree sees it."""
    x, y, z, w = fixed.turn
    back = (-x, -y, -z, w)
    a, b = place.position, fixed.position
    return Placed(place.root, rotated(back, (a[0] - b[0], a[1] - b[1], a[2] - b[2])), multiplied(back, place.turn))


def rotated(turn: Quaternion, vector: Vector) -> Vector:
    """The vector turned by a unit quaternion."""
    x, y, z, w = turn
    vx, vy, vz = vector
    tx, ty, tz = 2 * (y * vz - z * vy), 2 * (z * vx - x * vz), 2 * (x * vy - y * vx)
    return (vx + w * tx + y * tz - z * ty, vy + w * ty + z * tx - x * tz, vz + w * tz + x * ty - y * tx)


def multiplied(a: Quaternion, b: Quaternion) -> Quaternion:
    """First `b`, then `a`, as one turn."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def heading(turn: Quaternion) -> float:
    """Where the turned x axis points to when seen from above, in radians."""
    x, y, z, w = turn
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def _add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
