"""Quaternions as tuples (x, y, z, w)."""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, cos, pi, sin, sqrt
from typing import Any

from edulaunch.tf import quaternions as maths
from edulaunch.tf.quaternions import Matrix, Quaternion

SAME = 1e-15  # quaternions whose product is this near to 1 are taken as one rotation


def quaternion_multiply(quaternion1: Sequence[float], quaternion0: Sequence[float]) -> Quaternion:
    """First rotate by `quaternion0`, then by `quaternion1`."""
    return maths.multiply(_four(quaternion1), _four(quaternion0))


def quaternion_conjugate(quaternion: Sequence[float]) -> Quaternion:
    """The opposite rotation of a unit quaternion."""
    x, y, z, w = _four(quaternion)
    return (-x, -y, -z, w)


def quaternion_inverse(quaternion: Sequence[float]) -> Quaternion:
    """The quaternion that gives (0, 0, 0, 1) when multiplied with the given one, whatever its length."""
    x, y, z, w = _four(quaternion)
    square = x * x + y * y + z * z + w * w
    return (-x / square, -y / square, -z / square, w / square)


def quaternion_about_axis(angle: float, axis: Sequence[float]) -> Quaternion:
    """A turn by an angle about an axis of any length."""
    x, y, z = axis
    length = sqrt(x * x + y * y + z * z)
    scale = sin(angle / 2.0) / length
    return (float(x * scale), float(y * scale), float(z * scale), cos(angle / 2.0))


def quaternion_slerp(
    quat0: Sequence[float], quat1: Sequence[float], fraction: float, spin: int = 0, shortestpath: bool = True
) -> Quaternion:
    """The rotation a fraction (0 to 1) of the way from one to the other.

    :param spin: so many half turns more on the way.
    :param shortestpath: go the shorter way round.
    """
    start, end = _unit(quat0), _unit(quat1)
    cosine = sum(a * b for a, b in zip(start, end, strict=True))
    if fraction in (0.0, 1.0) or abs(cosine) >= 1.0 - SAME:
        return end if fraction == 1.0 else start
    turned = -1.0 if shortestpath and cosine < 0.0 else 1.0
    angle = acos(turned * cosine) + spin * pi
    first, second = sin((1.0 - fraction) * angle) / sin(angle), turned * sin(fraction * angle) / sin(angle)
    x, y, z, w = (first * a + second * b for a, b in zip(start, end, strict=True))
    return (x, y, z, w)


def quaternion_matrix(quaternion: Sequence[float]) -> Any:
    """The 4x4 homogeneous matrix of a rotation; a zero quaternion gives the identity."""
    return homogeneous(rotation_rows(quaternion))


def quaternion_from_matrix(matrix: Any) -> Quaternion:
    """The rotation of a 4x4 or 3x3 matrix, with w >= 0."""
    rows = [[float(matrix[i][j]) for j in range(3)] for i in range(3)]
    x, y, z, w = maths.from_matrix((tuple(rows[0]), tuple(rows[1]), tuple(rows[2])))  # type: ignore[arg-type]
    return (-x, -y, -z, -w) if w < 0.0 else (x, y, z, w)


def vector_norm(data: Any, axis: int | None = None, out: Any = None) -> Any:
    """The length of a vector, or of the vectors along an axis; with `out`, stored there and None returned."""
    import numpy

    length = numpy.linalg.norm(numpy.asarray(data, dtype=float), axis=axis)
    if out is None:
        return length
    out[...] = length
    return None


def unit_vector(data: Any, axis: int | None = None, out: Any = None) -> Any:
    """The vector (or the vectors along an axis) of length 1 in the same direction; with `out`, stored there and None returned."""
    import numpy

    values = numpy.array(data, dtype=float)
    values /= numpy.linalg.norm(values, axis=axis, keepdims=axis is not None)
    if out is None:
        return values
    out[...] = values
    return None


def rotation_rows(quaternion: Sequence[float]) -> Matrix:
    """The 3x3 rotation of a quaternion, by rows."""
    values = _four(quaternion)
    return maths.to_matrix(values if any(values) else maths.IDENTITY)


def homogeneous(rows: Matrix) -> Any:
    """A 3x3 rotation as a 4x4 array."""
    import numpy

    matrix = numpy.identity(4)
    matrix[:3, :3] = rows
    return matrix


def _unit(quaternion: Sequence[float]) -> Quaternion:
    x, y, z, w = _four(quaternion)
    length = sqrt(x * x + y * y + z * z + w * w)
    return (x / length, y / length, z / length, w / length)


def _four(quaternion: Sequence[float]) -> Quaternion:
    x, y, z, w = quaternion
    return (float(x), float(y), float(z), float(w))
