"""Euler angles to quaternion, as the tf2 tutorials need it."""

from __future__ import annotations

from math import cos, sin


def quaternion_from_euler(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """Quaternion (x, y, z, w) of turning about the fixed axes x, then y, then z; angles in radians."""
    sr, cr = sin(roll / 2.0), cos(roll / 2.0)
    sp, cp = sin(pitch / 2.0), cos(pitch / 2.0)
    sy, cy = sin(yaw / 2.0), cos(yaw / 2.0)
    return (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)
