"""A ball turned with a pointer."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, sqrt
from typing import Any

from edulaunch.tf.quaternions import IDENTITY, Quaternion, Vector
from tf_transformations.quaternions import (
    quaternion_from_matrix,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
    unit_vector,
)

EPSILON = 1e-12


class Arcball:
    """The rotation of a ball that is pushed down at one place of the screen and dragged to another.

    :param initial: where it starts: a quaternion (x, y, z, w) or a matrix.
    """

    def __init__(self, initial: Any = None) -> None:
        self._centre, self._radius = (0.0, 0.0), 1.0
        self._pressed: Vector = (0.0, 0.0, 1.0)
        self._axes: list[Vector] | None = None
        self._axis: Vector | None = None
        self._constrain = False
        self._at_press = self._before = self._now = IDENTITY if initial is None else _rotation(initial)

    def place(self, center: Sequence[float], radius: float) -> None:
        """Where the ball lies on the screen: its middle and radius in pixels, y downwards."""
        self._centre, self._radius = (float(center[0]), float(center[1])), float(radius)

    def setaxes(self, *axes: Sequence[float] | None) -> None:
        """The axes that a constrained turn may choose from; None: no axes."""
        given = [axis for axis in axes if axis is not None]
        self._axes = [_three(unit_vector(axis)) for axis in given] or None

    def setconstrain(self, constrain: bool) -> None:
        """Turn about the nearest of the axes only."""
        self._constrain = bool(constrain)

    def getconstrain(self) -> bool:
        """Whether turns are about an axis only."""
        return self._constrain

    def down(self, point: Sequence[float]) -> None:
        """The pointer is pressed at a place of the screen."""
        self._pressed = arcball_map_to_sphere(point, self._centre, self._radius)
        self._at_press = self._before = self._now
        self._axis = None
        if self._constrain and self._axes is not None:
            self._axis = arcball_nearest_axis(self._pressed, self._axes)
            self._pressed = arcball_constrain_to_axis(self._pressed, self._axis)

    def drag(self, point: Sequence[float]) -> None:
        """The pointer moves on to a place of the screen: the ball turns twice the arc between the two places."""
        here = arcball_map_to_sphere(point, self._centre, self._radius)
        if self._axis is not None:
            here = arcball_constrain_to_axis(here, self._axis)
        self._before = self._now
        axis = _cross(self._pressed, here)
        turn: Quaternion = (*axis, _dot(self._pressed, here))
        self._now = self._at_press if _dot(axis, axis) < EPSILON else quaternion_multiply(turn, self._at_press)

    def next(self, acceleration: float = 0.0) -> None:
        """Turn on as in the last step, faster by a fraction."""
        self._before, self._now = self._now, quaternion_slerp(self._before, self._now, 2.0 + acceleration)

    def matrix(self) -> Any:
        """The rotation as a 4x4 matrix."""
        return quaternion_matrix(self._now)


def arcball_map_to_sphere(point: Sequence[float], center: Sequence[float], radius: float) -> Vector:
    """The place on the unit sphere that lies below a place on the screen, or the nearest on its rim."""
    x, y = (point[0] - center[0]) / radius, (center[1] - point[1]) / radius
    away = hypot(x, y)
    return (x / away, y / away, 0.0) if away > 1.0 else (x, y, sqrt(1.0 - away * away))


def arcball_constrain_to_axis(point: Sequence[float], axis: Sequence[float]) -> Vector:
    """The nearest place of the front half of the circle about an axis."""
    height = _dot(point, axis)
    x, y, z = (p - height * a for p, a in zip(point[:3], axis[:3], strict=True))
    away = sqrt(x * x + y * y + z * z)
    if away > EPSILON:
        away = -away if z < 0.0 else away
        return (x / away, y / away, z / away)
    return (1.0, 0.0, 0.0) if axis[2] == 1.0 else _three(unit_vector((-axis[1], axis[0], 0.0)))


def arcball_nearest_axis(point: Sequence[float], axes: Sequence[Sequence[float]]) -> Vector:
    """The axis whose circle passes nearest to a place; the first of several."""
    return _three(max(axes, key=lambda axis: _dot(arcball_constrain_to_axis(point, axis), point)))


def _rotation(initial: Any) -> Quaternion:
    if len(initial) == 4 and not hasattr(initial[0], '__len__'):
        return _unit(initial)
    return quaternion_from_matrix(initial)


def _unit(values: Any) -> Quaternion:
    x, y, z, w = (float(value) for value in unit_vector(values))
    return (x, y, z, w)


def _three(values: Any) -> Vector:
    return (float(values[0]), float(values[1]), float(values[2]))


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return float(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


def _cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
