"""Matrices that slide the planes of space along each other."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan, cos, radians, sin, sqrt, tan
from typing import Any

from tf_transformations.projections import columns_and_rows
from tf_transformations.quaternions import unit_vector


def shear_matrix(angle: float, direction: Sequence[float], point: Sequence[float], normal: Sequence[float]) -> Any:
    """A shear by an angle along a direction in the plane through a point, which stays where it is.

    :raises ValueError: when the direction does not lie in the plane.
    """
    import numpy

    along, axis = unit_vector(direction[:3]), unit_vector(normal[:3])
    if abs(along @ axis) > 1e-6:
        raise ValueError('direction and normal vectors are not orthogonal')
    slope = tan(angle)
    matrix = numpy.identity(4)
    matrix[:3, :3] += slope * numpy.outer(along, axis)
    matrix[:3, 3] = -slope * (numpy.array(point[:3], dtype=float) @ axis) * along
    return matrix


def shear_from_matrix(matrix: Any) -> tuple[float, Any, Any, Any]:
    """(angle, direction, point, normal) of a shear; the angle is positive, the point homogeneous.

    :raises ValueError: for a matrix that is no shear.
    """
    import numpy

    given = numpy.array(matrix, dtype=float)
    slid = given[:3, :3] - numpy.identity(3)
    if abs(slid).max() < 1e-12 or not numpy.allclose(slid @ slid, 0.0, atol=1e-6):
        raise ValueError(f'no two linear independent eigenvectors found {numpy.linalg.eigvals(given[:3, :3])}')
    direction, normal = columns_and_rows(slid)
    slope = float(direction @ slid @ normal)
    if slope < 0.0:
        slope, direction = -slope, -direction
    return atan(slope), direction, numpy.append(-(given[:3, 3] @ direction) / slope * normal, 1.0), normal


def orthogonalization_matrix(lengths: Sequence[float], angles: Sequence[float]) -> Any:
    """From the coordinates of a crystal's cell (lengths a, b, c and angles alpha, beta, gamma in DEGREES) to right-angled ones.

    The third edge lies on the z axis, the second in the plane of y and z.
    """
    import numpy

    a, b, c = lengths[:3]
    alpha, beta, gamma = (radians(angle) for angle in angles[:3])
    across = (cos(gamma) - cos(alpha) * cos(beta)) / sin(alpha)  # of the first edge's unit vector, along y
    upright = sqrt(sin(beta) ** 2 - across**2)
    matrix = numpy.identity(4)
    matrix[:3, 0] = a * upright, a * across, a * cos(beta)
    matrix[:3, 1] = 0.0, b * sin(alpha), b * cos(alpha)
    matrix[2, 2] = c
    return matrix
