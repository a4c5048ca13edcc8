"""Matrices that press space onto a plane or into a cube, and what such a matrix is made of.

A plane is given by a point in it and its normal, of any length. Points that are read from a matrix are homogeneous
(x, y, z, 1), directions and normals have length 1.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tf_transformations.quaternions import unit_vector

EPSILON = 1e-8


def projection_matrix(
    point: Sequence[float],
    normal: Sequence[float],
    direction: Sequence[float] | None = None,
    perspective: Sequence[float] | None = None,
    pseudo: bool = False,
) -> Any:
    """The projection onto a plane: along a direction, else from a perspective point, else at a right angle.

    :param pseudo: keep the order of distances from the perspective point.
    """
    import numpy

    plane, axis = numpy.array(point[:3], dtype=float), unit_vector(normal[:3])
    if perspective is not None:
        return _from_centre(numpy.array(perspective[:3], dtype=float), axis, float(plane @ axis), pseudo)
    along = axis if direction is None else numpy.array(direction[:3], dtype=float)
    along = along / (along @ axis)
    matrix = numpy.identity(4)
    matrix[:3, :3] -= numpy.outer(along, axis)
    matrix[:3, 3] = (plane @ axis) * along
    return matrix


def projection_from_matrix(matrix: Any, pseudo: bool = False) -> tuple[Any, Any, Any, Any, bool]:
    """(point, normal, direction, perspective, pseudo) of a projection: what :func:`projection_matrix` makes it of.

    Either the direction or the perspective point is None.

    :raises ValueError: for a matrix that is no projection.
    """
    import numpy

    given = numpy.array(matrix, dtype=float)
    if pseudo or numpy.linalg.norm(given[3, :3]) > EPSILON:
        return _seen_from_a_point(given, pseudo)
    if abs(given[3, 3]) < EPSILON:
        raise ValueError('no eigenvector not corresponding to eigenvalue 0')
    given /= given[3, 3]
    lost = numpy.identity(3) - given[:3, :3]
    if not numpy.allclose(lost @ lost, lost, atol=1e-6) or abs(numpy.trace(lost) - 1.0) > 1e-6:
        raise ValueError('no eigenvector corresponding to eigenvalue 0')
    direction, normal = columns_and_rows(lost)
    return numpy.append(given[:3, 3], 1.0), normal, direction, None, False


def clip_matrix(left: float, right: float, bottom: float, top: float, near: float, far: float, perspective: bool = False) -> Any:
    """What maps a box (or, with perspective, a frustum seen along +z) to the cube from -1 to 1 on each axis.

    :raises ValueError: when an upper limit is not above its lower one, or the frustum begins at the eye or behind it.
    """
    import numpy

    if left >= right or bottom >= top or near >= far:
        raise ValueError('invalid frustum')
    if perspective and near <= EPSILON:
        raise ValueError('invalid frustum: near <= 0')
    matrix = numpy.zeros((4, 4))
    for row, (low, high) in enumerate(((left, right), (bottom, top), (near, far))):
        matrix[row, row] = 2.0 / (high - low)
        matrix[row, 3] = -(high + low) / (high - low)
    matrix[3, 3] = 1.0
    return matrix @ _frustum_to_box(near, far) if perspective else matrix


def columns_and_rows(product: Any) -> tuple[Any, Any]:
    """The unit vectors (u, v) of a matrix that is a multiple of the outer product of u and v."""
    import numpy

    row, column = numpy.unravel_index(abs(product).argmax(), product.shape)
    return unit_vector(product[:, column]), unit_vector(product[row])


def _from_centre(centre: Any, axis: Any, distance: float, pseudo: bool) -> Any:
    """Onto the plane at a distance from the origin along its normal, from a centre."""
    import numpy

    matrix = numpy.zeros((4, 4))
    matrix[:3, :3] = (centre @ axis - distance) * numpy.identity(3) - numpy.outer(centre, axis)
    matrix[:3, 3] = distance * centre
    if pseudo:
        matrix[:3, :3] -= numpy.outer(axis, axis)
        matrix[:3, 3] += distance * axis
    matrix[3, :3] = -axis
    matrix[3, 3] = centre @ axis
    return matrix


def _seen_from_a_point(given: Any, pseudo: bool) -> tuple[Any, Any, Any, Any, bool]:
    """The parts of :func:`_from_centre`, whatever number the matrix was multiplied with."""
    import numpy

    length = numpy.linalg.norm(given[3, :3])
    if length < EPSILON:
        raise ValueError('no eigenvector not corresponding to eigenvalue 0')
    given = given / length
    axis, depth = -given[3, :3], given[3, 3]
    gap = (numpy.trace(given[:3, :3]) + depth + pseudo) / 3.0
    centre = gap * axis - given[:3, :3] @ axis - pseudo * axis
    return numpy.append((depth - gap) * axis, 1.0), axis, None, centre, pseudo


def _frustum_to_box(near: float, far: float) -> Any:
    """What turns the rays of a frustum into parallels, such that the near face and the distance of the far one stay."""
    import numpy

    matrix = numpy.diag([-near, -near, -(near + far), 0.0])
    matrix[2, 3], matrix[3, 2] = near * far, -1.0
    return matrix
