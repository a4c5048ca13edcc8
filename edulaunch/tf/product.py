"""The product of transforms along a chain of frames: the inner loop of every lookup."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from edulaunch.tf.transforms import Transform


def product(poses: Sequence[Transform]) -> Transform:
    """top_from_bottom, from each frame's pose in the next one, bottom first.

    `transforms.compose` written out, and shortened for frames that turn about the z axis only (a turtle, a robot on the floor,
    a sensor on it): a third of the work, and the same numbers.
    """
    rest = iter(poses)
    x, y, z, qx, qy, qz, qw = bottom = next(rest)
    if qx or qy:
        return _product_on(bottom, rest)
    left: list[Transform] = []
    for px, py, pz, ax, ay, az, aw in rest:
        if ax or ay:
            left = [(px, py, pz, ax, ay, az, aw), *rest]
            break
        ux, uy = -2.0 * (az * y), 2.0 * (az * x)
        x += px + aw * ux - az * uy
        y += py + aw * uy + az * ux
        z += pz
        qz, qw = aw * qz + az * qw, aw * qw - az * qz
    if x - x or y - y or z - z:  # infinite lengths need the products with zero that were left out
        return _product_on(bottom, poses[1:])
    return _product_on((x, y, z, qx, qy, qz, qw), left) if left else (x, y, z, qx, qy, qz, qw)


def _product_on(pose: Transform, poses: Iterable[Transform]) -> Transform:
    """The product for turns about any axis, with that of the frames below."""
    x, y, z, qx, qy, qz, qw = pose
    for px, py, pz, ax, ay, az, aw in poses:
        ux = 2.0 * (ay * z - az * y)
        uy = 2.0 * (az * x - ax * z)
        uz = 2.0 * (ax * y - ay * x)
        x += px + aw * ux + ay * uz - az * uy
        y += py + aw * uy + az * ux - ax * uz
        z += pz + aw * uz + ax * uy - ay * ux
        bx, by, bz = qx, qy, qz
        qx = aw * bx + ax * qw + ay * bz - az * by
        qy = aw * by - ax * bz + ay * qw + az * bx
        qz = aw * bz + ax * by - ay * bx + az * qw
        qw = aw * qw - ax * bx - ay * by - az * bz
    return (x, y, z, qx, qy, qz, qw)
