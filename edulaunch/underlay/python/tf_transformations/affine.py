"""Matrices that do more than turn and shift, and what a matrix is made of."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2
from typing import Any

from tf_transformations.eulers import euler_from_matrix, euler_matrix
from tf_transformations.matrices import identity_matrix, translation_matrix
from tf_transformations.projections import columns_and_rows
from tf_transformations.quaternions import unit_vector

EPSILON = 1e-9


def scale_matrix(factor: float, origin: Sequence[float] | None = None, direction: Sequence[float] | None = None) -> Any:
    """Larger by a factor (-1: mirrored in a point), about an origin; with a direction, along that only."""
    import numpy

    matrix = identity_matrix()
    if direction is None:
        matrix[:3, :3] *= factor
    else:
        axis = unit_vector(direction[:3])
        matrix[:3, :3] -= (1.0 - factor) * numpy.outer(axis, axis)
    return _about(matrix, origin)


def reflection_matrix(point: Sequence[float], normal: Sequence[float]) -> Any:
    """The mirror image in the plane through a point."""
    return scale_matrix(-1.0, point, normal)


def reflection_from_matrix(matrix: Any) -> tuple[Any, Any]:
    """(a point of the mirror, homogeneous; its normal) of a matrix that mirrors in a plane.

    :raises ValueError: for a matrix that does not.
    """
    import numpy

    given = numpy.array(matrix, dtype=float)[:3, :3]
    if not numpy.allclose(given @ given, numpy.identity(3)) or abs(numpy.trace(given) - 1.0) > 1e-6:
        raise ValueError('no unit eigenvector corresponding to eigenvalue -1')
    _, point, normal = scale_from_matrix(matrix)
    return point, normal


def scale_from_matrix(matrix: Any) -> tuple[float, Any, Any]:
    """(factor, origin, direction) of a matrix that scales; the origin is homogeneous, the direction None for all directions.

    :raises ValueError: for a matrix that does more than that.
    """
    import numpy

    given = numpy.array(matrix, dtype=float)
    lost, shift = numpy.identity(3) - given[:3, :3], given[:3, 3]
    same = float(numpy.trace(lost)) / 3.0
    if numpy.allclose(lost, same * numpy.identity(3)):
        factor, direction, moved = 1.0 - same, None, shift
    else:
        factor = 1.0 - 3.0 * same
        direction, _ = columns_and_rows(lost)
        moved = (shift @ direction) * direction
        if not numpy.allclose(lost, (1.0 - factor) * numpy.outer(direction, direction)):
            raise ValueError('no eigenvector corresponding to eigenvalue 1')
    if not numpy.allclose(shift, moved) or (abs(factor - 1.0) < EPSILON and numpy.linalg.norm(shift) > EPSILON):
        raise ValueError('no eigenvector corresponding to eigenvalue 1')
    origin = shift / (1.0 - factor) if abs(factor - 1.0) >= EPSILON else numpy.zeros(3)
    return factor, numpy.append(origin, 1.0), direction


def rotation_from_matrix(matrix: Any) -> tuple[float, Any, Any]:
    """(angle, axis, a point on the axis) of a matrix that turns about an axis.

    :raises ValueError: when nothing but the origin stays where it is, so that it is no rotation.
    """
    import numpy

    given = numpy.array(matrix, dtype=float)
    turn = given[:3, :3]
    if abs(numpy.linalg.det(turn) - 1.0) > 1e-6:
        raise ValueError('no unit eigenvector corresponding to eigenvalue 1')
    values, vectors = numpy.linalg.eig(turn.T)
    axis = numpy.real(vectors[:, numpy.argmin(abs(values - 1.0))]).squeeze()
    values, vectors = numpy.linalg.eig(given)
    point = numpy.real(vectors[:, max(numpy.flatnonzero(abs(values - 1.0) < 1e-8))]).squeeze()
    sine = numpy.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) @ axis / 2.0
    return atan2(sine, (numpy.trace(turn) - 1.0) / 2.0), axis, point / point[3]


def compose_matrix(
    scale: Sequence[float] | None = None,
    shear: Sequence[float] | None = None,
    angles: Sequence[float] | None = None,
    translate: Sequence[float] | None = None,
    perspective: Sequence[float] | None = None,
) -> Any:
    """The matrix that scales, shears (xy, xz, yz), turns (roll, pitch, yaw) and shifts, in this order."""
    import numpy

    matrix = identity_matrix()
    if perspective is not None:
        matrix[3, :] = perspective[:4]
    if translate is not None:
        matrix = matrix @ translation_matrix(translate)
    if angles is not None:
        matrix = matrix @ euler_matrix(angles[0], angles[1], angles[2], 'sxyz')
    if shear is not None:
        sheared = identity_matrix()
        sheared[0, 1], sheared[0, 2], sheared[1, 2] = shear
        matrix = matrix @ sheared
    if scale is not None:
        matrix = matrix @ numpy.diag([*scale[:3], 1.0])
    return matrix / matrix[3, 3]


def decompose_matrix(matrix: Any) -> tuple[Any, list[float], tuple[float, float, float], Any, Any]:
    """(scale, shear, angles, translate, perspective) of a matrix: what :func:`compose_matrix` makes it of.

    :raises ValueError: for a matrix that cannot be undone.
    """
    import numpy

    given = numpy.array(matrix, dtype=float)
    if abs(given[3, 3]) < EPSILON:
        raise ValueError('M[3, 3] is zero')
    given /= given[3, 3]
    if abs(numpy.linalg.det(given[:3, :3])) < EPSILON:
        raise ValueError('Matrix is singular')
    turn, upper = numpy.linalg.qr(given[:3, :3])
    signs = numpy.diag(numpy.sign(numpy.diag(upper)))
    turn, upper = turn @ signs, signs @ upper
    scale = numpy.diag(upper).copy()
    if numpy.linalg.det(turn) < 0.0:
        turn, upper, scale = -turn, -upper, -scale
    shear = upper / scale
    perspective = given[3] @ numpy.linalg.inv(numpy.vstack([given[:3], [0.0, 0.0, 0.0, 1.0]]))
    return scale, [float(shear[0, 1]), float(shear[0, 2]), float(shear[1, 2])], euler_from_matrix(turn), given[:3, 3], perspective


def is_same_transform(matrix0: Any, matrix1: Any) -> bool:
    """Whether two matrices do the same, up to rounding."""
    import numpy

    one, other = (numpy.array(matrix, dtype=float) / numpy.array(matrix, dtype=float)[3, 3] for matrix in (matrix0, matrix1))
    return bool(numpy.allclose(one, other))


def _about(matrix: Any, origin: Sequence[float] | None) -> Any:
    """The same with another point staying where it is."""
    if origin is not None:
        import numpy

        centre = numpy.array(origin[:3], dtype=float)
        matrix[:3, 3] = centre - matrix[:3, :3] @ centre
    return matrix
