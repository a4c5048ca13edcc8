"""Euler angles about any of the 24 sequences of axes."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, hypot, sin
from typing import Any

from edulaunch.tf.quaternions import IDENTITY, Quaternion, Vector, multiply
from tf_transformations.quaternions import homogeneous, rotation_rows

Axes = str | tuple[int, int, int, int]
FLAT = 1e-12  # below this a sine or cosine is taken as zero


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Axes = 'sxyz') -> Quaternion:
    """The rotation (x, y, z, w) of three angles in radians; with the default axes: roll, pitch, yaw."""
    frame, letters = _parse(axes)
    turns = [_about(axis, angle) for axis, angle in zip(letters, (ai, aj, ak), strict=True)]
    result = IDENTITY
    for turn in turns:
        result = multiply(turn, result) if frame == 's' else multiply(result, turn)
    return result


def euler_from_quaternion(quaternion: Sequence[float], axes: Axes = 'sxyz') -> Vector:
    """The three angles of a rotation (x, y, z, w); with the default axes: roll, pitch, yaw."""
    return _angles(rotation_rows(quaternion), axes)


def euler_matrix(ai: float, aj: float, ak: float, axes: Axes = 'sxyz') -> Any:
    """The 4x4 homogeneous matrix of three angles."""
    return homogeneous(rotation_rows(quaternion_from_euler(ai, aj, ak, axes)))


def euler_from_matrix(matrix: Any, axes: Axes = 'sxyz') -> Vector:
    """The three angles of a 3x3 or 4x4 matrix."""
    return _angles([[float(matrix[i][j]) for j in range(3)] for i in range(3)], axes)


def _parse(axes: Axes) -> tuple[str, tuple[int, int, int]]:
    if not isinstance(axes, str):
        return _named_by_numbers(axes)
    frame, letters = axes[:1].lower(), tuple('xyz'.find(letter) for letter in axes[1:].lower())
    named = frame in ('s', 'r') and len(letters) == 3 and -1 not in letters
    if not named or letters[1] in (letters[0], letters[2]):
        raise KeyError(axes)
    return frame, (letters[0], letters[1], letters[2])


def _named_by_numbers(axes: tuple[int, int, int, int]) -> tuple[str, tuple[int, int, int]]:
    """(first axis, 1 for an odd order, 1 when it comes again, 1 for turning axes), which reverses the order."""
    first, odd, again, turning = axes
    if first not in (0, 1, 2) or any(flag not in (0, 1) for flag in (odd, again, turning)):
        raise KeyError(axes)
    second, third = (first + 1 + odd) % 3, (first + 2 - odd) % 3
    letters = (first, second, first if again else third)
    return ('r', letters[::-1]) if turning else ('s', letters)


def _about(axis: int, angle: float) -> Quaternion:
    values = [0.0, 0.0, 0.0, cos(angle / 2.0)]
    values[axis] = sin(angle / 2.0)
    return (values[0], values[1], values[2], values[3])


def _angles(rows: Sequence[Sequence[float]], axes: Axes) -> Vector:
    """Turns about fixed axes are turns about moving axes in reverse order, so only those are solved."""
    frame, letters = _parse(axes)
    i, j, k = letters if frame == 'r' else letters[::-1]
    a, b, c = _proper(rows, i, j) if i == k else _tait_bryan(rows, i, j, k)
    return (a, b, c) if frame == 'r' else (c, b, a)


def _tait_bryan(m: Sequence[Sequence[float]], i: int, j: int, k: int) -> Vector:
    """a, b, c of R = Ri(a) Rj(b) Rk(c), three different axes; a = 0 where only a sum of a and c is known."""
    even = 1.0 if (j - i) % 3 == 1 else -1.0
    cosine = hypot(m[i][i], m[i][j])
    b = atan2(even * m[i][k], cosine)
    if cosine < FLAT:
        return (0.0, b, atan2(even * m[j][i], m[j][j]))
    return (atan2(-even * m[j][k], m[k][k]), b, atan2(-even * m[i][j], m[i][i]))


def _proper(m: Sequence[Sequence[float]], i: int, j: int) -> Vector:
    """a, b, c of R = Ri(a) Rj(b) Ri(c); a = 0 where only a sum of a and c is known."""
    third = 3 - i - j
    even = 1.0 if (j - i) % 3 == 1 else -1.0
    sine = hypot(m[i][j], m[i][third])
    b = atan2(sine, m[i][i])
    if sine < FLAT:
        return (0.0, b, atan2(-even * m[j][third], m[j][j]))
    return (atan2(m[j][i], -even * m[third][i]), b, atan2(m[i][j], even * m[i][third]))
