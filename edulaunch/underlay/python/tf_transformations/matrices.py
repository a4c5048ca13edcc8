"""Homogeneous 4x4 matrices as numpy arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tf_transformations.quaternions import quaternion_about_axis, quaternion_matrix


def identity_matrix() -> Any:
    """No rotation, no translation."""
    import numpy

    return numpy.identity(4)


def translation_matrix(direction: Sequence[float]) -> Any:
    """A shift by a vector."""
    matrix = identity_matrix()
    matrix[:3, 3] = direction[:3]
    return matrix


def translation_from_matrix(matrix: Any) -> Any:
    """The shift of a matrix, as an array of 3 numbers."""
    import numpy

    return numpy.array(matrix)[:3, 3].copy()


def rotation_matrix(angle: float, direction: Sequence[float], point: Sequence[float] | None = None) -> Any:
    """A turn by an angle about an axis, through the origin or through a point."""
    matrix = quaternion_matrix(quaternion_about_axis(angle, direction[:3]))
    if point is not None:
        import numpy

        centre = numpy.array(point[:3], dtype=float)
        matrix[:3, 3] = centre - matrix[:3, :3] @ centre
    return matrix


def inverse_matrix(matrix: Any) -> Any:
    """The matrix that undoes the given one."""
    import numpy

    return numpy.linalg.inv(matrix)


def concatenate_matrices(*matrices: Any) -> Any:
    """The product of all matrices, the last of which is applied first."""
    import numpy

    result = numpy.identity(4)
    for matrix in matrices:
        result = result @ numpy.asarray(matrix)
    return result
