"""Rotations as unit quaternions: plain tuples (x, y, z, w), in the order of the fields in ROS messages.

Angles are radians. Euler angles are tf2's roll, pitch, yaw about *fixed* axes: R = Rz(yaw) Ry(pitch) Rx(roll).
"""

from __future__ import annotations

from math import asin, atan2, copysign, cos, inf, nan, pi, sin, sqrt

Quaternion = tuple[float, float, float, float]
Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]

IDENTITY: Quaternion = (0.0, 0.0, 0.0, 1.0)
TINY, HUGE = 1e-100, 1e100  # squared lengths outside these limits overflow or underflow in floating point
NEGATIVE_NAN = copysign(nan, -1.0)


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the Hamilton product, which first rotates by `b`, then by `a`.

    :param a: a quaternion (x, y, z, w) of any length.
    :param b: a quaternion (x, y, z, w) of any length. The length of the product is the product of both lengths.
    """
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """Return the inverse rotation of a unit quaternion `q`, as (x, y, z, w)."""
    return (0.0 - q[0], 0.0 - q[1], 0.0 - q[2], q[3])


def rotate(q: Quaternion, v: Vector) -> Vector:
    """Return the vector `v`, rotated about the origin.

    :param q: a unit quaternion (x, y, z, w). A quaternion of another length gives a wrong vector, and no error.
    :param v: (x, y, z) in any unit; the result has the same unit.
    """
    qx, qy, qz, qw = q
    x, y, z = v
    ux, uy, uz = 2.0 * (qy * z - qz * y), 2.0 * (qz * x - qx * z), 2.0 * (qx * y - qy * x)
    return (x + qw * ux + qy * uz - qz * uy, y + qw * uy + qz * ux - qx * uz, z + qw * uz + qx * uy - qy * ux)


def canonical(q: Quaternion) -> Quaternion:
    """Return the quaternion of length 1 that tf2 shows for the rotation `q`.

    q and -q are the same rotation. tf2 converts every rotation to a matrix and back, which determines the sign. For rotations
    below 120 degrees (trace > 0), w is positive. Otherwise, the largest of x, y, z is positive and w may be negative. A zero
    quaternion, and a quaternion with nan or infinity, become nan.
    """
    x, y, z, w = q
    square = x * x + y * y + z * z + w * w
    if not TINY < square < HUGE:
        return from_matrix(to_matrix(q))
    scale = 1.0 / sqrt(square)
    w *= scale
    decisive = w
    if w * w <= 0.25:
        decisive = x if y * y <= x * x >= z * z else y if y * y >= z * z else z
    if decisive < 0.0:
        scale = -scale
        w = -w
    return (x * scale + 0.0, y * scale + 0.0, z * scale + 0.0, w + 0.0)  # + 0.0 turns -0.0 into 0.0


def to_matrix(q: Quaternion) -> Matrix:
    """Return the 3x3 rotation matrix of the quaternion `q`, as rows. Any length is accepted; length 0 gives nan."""
    x, y, z, w = q
    square = x * x + y * y + z * z + w * w
    scale = 2.0 / square if square else inf
    xs, ys, zs = x * scale, y * scale, z * scale
    wx, wy, wz = w * xs, w * ys, w * zs
    xx, xy, xz = x * xs, x * ys, x * zs
    yy, yz, zz = y * ys, y * zs, z * zs
    return ((1.0 - (yy + zz), xy - wz, xz + wy), (xy + wz, 1.0 - (xx + zz), yz - wx), (xz - wy, yz + wx, 1.0 - (xx + yy)))


def from_matrix(m: Matrix) -> Quaternion:
    """Return the quaternion of the rotation matrix `m`, with tf2's choice of sign (see :func:`canonical`)."""
    trace = m[0][0] + m[1][1] + m[2][2]
    if trace > 0.0:
        s = sqrt(trace + 1.0)
        half = 0.5 / s
        return ((m[2][1] - m[1][2]) * half, (m[0][2] - m[2][0]) * half, (m[1][0] - m[0][1]) * half, s * 0.5)
    if trace != trace:  # written with the sign that x86 hardware, and so real tf2, gives to 0 * infinity
        return (NEGATIVE_NAN, NEGATIVE_NAN, NEGATIVE_NAN, NEGATIVE_NAN)
    i = 1 if m[0][0] < m[1][1] else 0
    i = 2 if m[i][i] < m[2][2] else i
    j, k = (i + 1) % 3, (i + 2) % 3
    s = sqrt(m[i][i] - m[j][j] - m[k][k] + 1.0)
    half = 0.5 / s
    out = [0.0, 0.0, 0.0, (m[k][j] - m[j][k]) * half]
    out[i], out[j], out[k] = s * 0.5, (m[j][i] + m[i][j]) * half, (m[k][i] + m[i][k]) * half
    return (out[0], out[1], out[2], out[3])


def from_euler(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the unit quaternion of a rotation by `roll` about x, then `pitch` about y, then `yaw` about z, as `setRPY` of tf2
    does.

    :param roll: the angle about the fixed x axis in radians.
    :param pitch: the angle about the fixed y axis in radians.
    :param yaw: the angle about the fixed z axis in radians.
    :returns: (x, y, z, w). Its sign may differ from that of :func:`canonical`.
    """
    cr, sr = cos(roll / 2.0), sin(roll / 2.0)
    cp, sp = cos(pitch / 2.0), sin(pitch / 2.0)
    cy, sy = cos(yaw / 2.0), sin(yaw / 2.0)
    return (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)


def to_euler(q: Quaternion) -> Vector:
    """Return (roll, pitch, yaw), in radians, of the quaternion `q`. At pitch = +-90 degrees, yaw is 0, as in tf2."""
    (m00, _, _), (m10, _, _), (m20, m21, m22) = to_matrix(q)
    if abs(m20) >= 1.0:
        return (atan2(m21, m22), copysign(pi / 2.0, -m20), 0.0)
    pitch = -asin(m20)
    c = cos(pitch)
    return (atan2(m21 / c, m22 / c), pitch, atan2(m10 / c, m00 / c))
