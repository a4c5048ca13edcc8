"""Fits a circle to points by least squares. The module uses only plain Python, because loading numpy takes a long time."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, sqrt
from typing import NamedTuple


class Circle(NamedTuple):
    """A circle with its centre and radius in metres. `residual` is the root mean square distance of the points from the
    circle.
    """

    x: float
    y: float
    radius: float
    residual: float


def fit_circle(points: Sequence[tuple[float, float]]) -> Circle | None:
    """Return the circle with the smallest sum of (|p - c|² - r²)² (the Kåsa fit). Return None for points on a line or in one
    place.

    The result is exact for points on an arc. The points are first moved so that their mean is the origin. So a circle far
    from the origin is as precise as a circle near it.
    """
    count = len(points)
    if count < 3:
        return None
    mean_x = sum(x for x, _ in points) / count
    mean_y = sum(y for _, y in points) / count
    centred = [(x - mean_x, y - mean_y) for x, y in points]
    centre = _centre(centred)
    if centre is None:
        return None
    u, v = centre
    radius = sqrt(u * u + v * v + sum(x * x + y * y for x, y in centred) / count)
    offs = [hypot(x - u, y - v) - radius for x, y in centred]
    residual = sqrt(sum(off * off for off in offs) / count)
    return Circle(mean_x + u, mean_y + v, radius, residual)


def _centre(centred: Sequence[tuple[float, float]]) -> tuple[float, float] | None:
    """Return the centre for points whose mean is the origin, by solving the 2 x 2 normal equations with Cramer's rule."""
    sxx = sxy = syy = sxz = syz = 0.0
    for x, y in centred:
        z = x * x + y * y
        sxx += x * x
        sxy += x * y
        syy += y * y
        sxz += x * z
        syz += y * z
    determinant = sxx * syy - sxy * sxy
    spread = sxx + syy
    if not determinant > 1e-9 * spread * spread:  # the points are on a line, or some are beyond 1e77 m
        return None
    return (sxz * syy - syz * sxy) / (2 * determinant), (syz * sxx - sxz * sxy) / (2 * determinant)
