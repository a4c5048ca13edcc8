"""The turn and the shift that bring one cloud of points onto another."""

from __future__ import annotations

from math import sqrt
from typing import Any

from tf_transformations.matrices import identity_matrix
from tf_transformations.quaternions import quaternion_matrix


def superimposition_matrix(v0: Any, v1: Any, scaling: bool = False, usesvd: bool = True) -> Any:
    """The 4x4 matrix that maps the points `v0` to the points `v1` with the smallest sum of squared distances.

    :param v0: an array of 3 (or 4, homogeneous) rows with a point per column.
    :param scaling: scale as well.
    :param usesvd: by the singular values of the covariance (Kabsch), else by the eigenvectors of a 4x4 matrix (Horn).
    :raises ValueError: when the shapes differ or there are fewer than 3 points.
    """
    import numpy

    before, after = (numpy.array(points, dtype=float)[:3] for points in (v0, v1))
    if before.shape != after.shape or before.ndim != 2 or before.shape[1] < 3:
        raise ValueError('input arrays are of wrong shape or type')
    centre, aim = before.mean(axis=1), after.mean(axis=1)
    before, after = before - centre[:, None], after - aim[:, None]
    turn = _kabsch(before, after) if usesvd else _horn(before, after)
    if scaling:
        turn = turn * sqrt((after**2).sum() / (before**2).sum())
    matrix = identity_matrix()
    matrix[:3, :3] = turn
    matrix[:3, 3] = aim - turn @ centre
    return matrix


def _kabsch(before: Any, after: Any) -> Any:
    """The best rotation; where a mirror image would fit better, the axis that matters least is turned back."""
    import numpy

    left, _, right = numpy.linalg.svd(after @ before.T)
    mirrored = numpy.linalg.det(left) * numpy.linalg.det(right) < 0.0
    return left @ numpy.diag([1.0, 1.0, -1.0 if mirrored else 1.0]) @ right


def _horn(before: Any, after: Any) -> Any:
    """The best rotation: its quaternion (x, y, z, w) belongs to the largest eigenvalue of a symmetric matrix."""
    import numpy

    s = before @ after.T
    table = numpy.empty((4, 4))
    table[:3, :3] = s + s.T - numpy.trace(s) * numpy.identity(3)
    table[3, :3] = table[:3, 3] = s[1, 2] - s[2, 1], s[2, 0] - s[0, 2], s[0, 1] - s[1, 0]
    table[3, 3] = numpy.trace(s)
    return quaternion_matrix(numpy.linalg.eigh(table)[1][:, -1])[:3, :3]
