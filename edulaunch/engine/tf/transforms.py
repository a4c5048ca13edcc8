"""Rigid transforms as flat tuples (x, y, z, qx, qy, qz, qw): metres and a unit quaternion.

A transform is named `target_from_source`. It converts coordinates in *source* to coordinates in *target*. It is also the pose of
the source frame in the target frame.
"""

from __future__ import annotations

from collections.abc import Sequence

from edulaunch.engine.tf import quaternions
from edulaunch.engine.tf.quaternions import Vector

Transform = tuple[float, float, float, float, float, float, float]

IDENTITY: Transform = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


def compose(c_from_b: Transform, b_from_a: Transform) -> Transform:
    """Return c_from_a, which applies `b_from_a` first and then `c_from_b`.

    :param c_from_b: (x, y, z, qx, qy, qz, qw): metres and a unit quaternion.
    :param b_from_a: (x, y, z, qx, qy, qz, qw): metres and a unit quaternion.
    """
    q = c_from_b[3:]
    x, y, z = quaternions.rotate(q, b_from_a[:3])
    return (x + c_from_b[0], y + c_from_b[1], z + c_from_b[2], *quaternions.multiply(q, b_from_a[3:]))


def product(poses: Sequence[Transform]) -> Transform:
    """Return top_from_bottom from `poses`: the pose of each frame in the next frame, bottom first.

    Lookups spend most of their time in this loop.
    """
    x, y, z, qx, qy, qz, qw = poses[0]
    for px, py, pz, ax, ay, az, aw in poses[1:]:
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


def relative(top_from_b: Transform, top_from_a: Transform) -> Transform:
    """Return b_from_a from the poses `top_from_b` and `top_from_a` in a common frame.

    The result is inverse(top_from_b) composed with top_from_a.
    """
    bx, by, bz, qx, qy, qz, qw = top_from_b
    ax, ay, az, rx, ry, rz, rw = top_from_a
    x, y, z = ax - bx, ay - by, az - bz
    ux, uy, uz = 2.0 * (qz * y - qy * z), 2.0 * (qx * z - qz * x), 2.0 * (qy * x - qx * y)
    return (
        x + qw * ux - qy * uz + qz * uy,
        y + qw * uy - qz * ux + qx * uz,
        z + qw * uz - qx * uy + qy * ux,
        qw * rx - qx * rw - qy * rz + qz * ry,
        qw * ry + qx * rz - qy * rw - qz * rx,
        qw * rz - qx * ry + qy * rx - qz * rw,
        qw * rw + qx * rx + qy * ry + qz * rz,
    )


def apply(b_from_a: Transform, point_in_a: Vector) -> Vector:
    """Return the coordinates of a point in frame b.

    :param b_from_a: the pose of frame a in frame b: metres and a unit quaternion.
    :param point_in_a: (x, y, z) in metres in frame a.
    """
    x, y, z = quaternions.rotate(b_from_a[3:], point_in_a)
    return (x + b_from_a[0], y + b_from_a[1], z + b_from_a[2])


def canonical(transform: Transform) -> Transform:
    """Return `transform` in the form that tf2 shows: a rotation of length 1 with tf2's sign, and no negative zeros."""
    x, y, z = transform[:3]
    return (x + 0.0, y + 0.0, z + 0.0, *quaternions.canonical(transform[3:]))
