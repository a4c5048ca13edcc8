"""One goal of the action rotate_absolute, as numbers."""

from __future__ import annotations

from math import floor, nan

from edulaunch.worlds.float32 import as_float32

PI = 3.14159265  # turtlesim's own pi; the missing digits decide which way 3.1416 turns
TWO_PI = 2.0 * PI
CLOSE_ENOUGH = 0.02


def normalize(angle: float) -> float:
    """The equivalent angle in [-PI, PI), radians; of infinity, as of nan, there is none but nan."""
    try:
        return angle - TWO_PI * floor((angle + PI) / TWO_PI)
    except (OverflowError, ValueError):
        return nan


def normalize_single(angle: float) -> float:
    """As :func:`normalize`, rounded to 32 bits."""
    return as_float32(normalize(angle))


class RotationGoal:
    """A turn to the absolute heading `theta` (radians), started at the heading `start`.

    `remaining` is the feedback and `delta` the result: start minus present heading, negative after a left
    turn.
    """

    __slots__ = ('theta', 'start', 'remaining', 'delta')

    def __init__(self, theta: float, start: float) -> None:
        self.theta = normalize_single(theta)
        self.start = as_float32(start)
        self.remaining = 0.0
        self.delta = 0.0

    def step(self, heading: float) -> float:
        """Look at the present heading: the angular velocity to turn with (rad/s), 0.0 at the goal."""
        heading = as_float32(heading)
        self.remaining = normalize_single(as_float32(self.theta - heading))
        self.delta = normalize_single(as_float32(self.start - heading))
        if abs(normalize_single(as_float32(heading - self.theta))) < CLOSE_ENOUGH:
            return 0.0
        return -1.0 if self.remaining < 0.0 else 1.0
