"""Quaternions as tuples (x, y, z, w)."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin, sqrt
from typing import Any

from edulaunch.tf import quaternions as maths
from edulaunch.tf.quaternions import Matrix, Quaternion


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


def quaternion_slerp(quat0: Sequence[float], quat1: Sequence[float], fraction: float) -> Quaternion:
    """The rotation a fraction (0 to 1) of the way from one to the other, the shorter way round."""
    return maths.slerp(maths.canonical(_four(quat0)), maths.canonical(_four(quat1)), fraction)


def quaternion_matrix(quaternion: Sequence[float]) -> Any:
    """The 4x4 homogeneous matrix of a rotation; a zero quaternion gives the identity."""
    return homogeneous(rotation_rows(quaternion))


def quaternion_from_matrix(matrix: Any) -> Quaternion:
    """The rotation of a 4x4 or 3x3 matrix, with w >= 0."""
    rows = [[float(matrix[i][j]) for j in range(3)] for i in range(3)]
    x, y, z, w = maths.from_matrix((tuple(rows[0]), tuple(rows[1]), tuple(rows[2])))  # type: ignore[arg-type]
    return (-x, -y, -z, -w) if w < 0.0 else (x, y, z, w)


def vector_norm(data: Any, axis: int | None = None) -> Any:
    """The length of a vector, or of the vectors along an axis."""
    import numpy

    return numpy.linalg.norm(data, axis=axis)


def unit_vector(data: Any) -> Any:
    """The vector of length 1 in the same direction."""
    import numpy

    values = numpy.array(data, dtype=float)
    return values / numpy.linalg.norm(values)


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


def _four(quaternion: Sequence[float]) -> Quaternion:
    x, y, z, w = quaternion
    return (float(x), float(y), float(z), float(w))
