"""Rigid transforms as flat tuples (x, y, z, qx, qy, qz, qw): metres and a unit quaternion.

A transform is named `target_from_source`: applied to coordinates given in *source* it yields coordinates in
*target*. It is also the pose of the source frame seen from the target frame.
"""

from __future__ import annotations

from math import acos, sin

from edulaunch.tf import quaternions
from edulaunch.tf.quaternions import Quaternion, Vector

Transform = tuple[float, float, float, float, float, float, float]

IDENTITY: Transform = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


def translation(transform: Transform) -> Vector:
    """The translation (x, y, z) in metres."""
    return transform[:3]


def rotation(transform: Transform) -> Quaternion:
    """The rotation (x, y, z, w)."""
    return transform[3:]


def compose(c_from_b: Transform, b_from_a: Transform) -> Transform:
    """c_from_a: first the right transform, then the left one."""
    q = c_from_b[3:]
    x, y, z = quaternions.rotate(q, b_from_a[:3])
    return (x + c_from_b[0], y + c_from_b[1], z + c_from_b[2], *quaternions.multiply(q, b_from_a[3:]))


def inverse(b_from_a: Transform) -> Transform:
    """a_from_b."""
    q = quaternions.conjugate(b_from_a[3:])
    x, y, z = quaternions.rotate(q, b_from_a[:3])
    return (0.0 - x, 0.0 - y, 0.0 - z, *q)


def relative(top_from_b: Transform, top_from_a: Transform) -> Transform:
    """b_from_a, from where both are seen from a common frame: inverse(top_from_b) composed with
    top_from_a.
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
    """The coordinates in b of a point given in a."""
    x, y, z = quaternions.rotate(b_from_a[3:], point_in_a)
    return (x + b_from_a[0], y + b_from_a[1], z + b_from_a[2])


def interpolate(older: Transform, newer: Transform, ratio: float) -> Transform:
    """The transform `ratio` of the way: translation on a straight line, rotation along the shorter arc.

    Equals :func:`edulaunch.tf.quaternions.slerp`, written out because lookups in the past spend their time
    here.
    """
    x, y, z, ax, ay, az, aw = older
    u, v, w, bx, by, bz, bw = newer
    rest = 1.0 - ratio
    dot = ax * bx + ay * by + az * bz + aw * bw
    if -1.0 < dot < 1.0:
        theta = acos(dot) if dot > 0.0 else acos(-dot)
        scale = 1.0 / sin(theta)
        s = sin(rest * theta) * scale
        t = sin(ratio * theta) * scale if dot > 0.0 else -sin(ratio * theta) * scale
        ax, ay, az, aw = ax * s + bx * t, ay * s + by * t, az * s + bz * t, aw * s + bw * t
    return (x * rest + u * ratio, y * rest + v * ratio, z * rest + w * ratio, ax, ay, az, aw)


def canonical(transform: Transform) -> Transform:
    """The same transform as tf2 shows it: rotation of length 1 with tf2's sign, no negative zeros."""
    x, y, z = transform[:3]
    return (x + 0.0, y + 0.0, z + 0.0, *quaternions.canonical(transform[3:]))
