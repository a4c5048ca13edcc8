"""The velocity of one frame relative to another frame, from two lookups."""

from __future__ import annotations

from math import atan2, sqrt

from edulaunch.engine.tf.buffer import TransformBuffer
from edulaunch.engine.tf.quaternions import Quaternion, Vector, conjugate, multiply


def lookup_velocity(
    buffer: TransformBuffer, tracking: str, observation: str, time_ns: int, averaging_ns: int
) -> tuple[Vector, Vector]:
    """Return the mean velocity of a frame's origin as (linear in m/s, angular in rad/s), in axes of the observation frame.

    :param buffer: the buffer with the transforms.
    :param tracking: the name of the moving frame.
    :param observation: the name of the frame relative to which the velocity is measured.
    :param time_ns: the middle of the time span in ns; 0 means the latest time.
    :param averaging_ns: the length of the time span in ns. If there is no data at the end of the span, the span is moved back.
    :raises TransformFailure: as in :meth:`TransformBuffer.lookup`.
    """
    latest_ns = buffer.lookup(observation, tracking)[0]
    end_ns = min((time_ns or latest_ns) + averaging_ns // 2, latest_ns)
    start_ns = max(averaging_ns, end_ns) - averaging_ns
    if end_ns == start_ns:
        return (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    start, end = (buffer.lookup(observation, tracking, start_ns)[1], buffer.lookup(observation, tracking, end_ns)[1])
    span_s = (end_ns - start_ns) * 1e-9
    linear = ((end[0] - start[0]) / span_s, (end[1] - start[1]) / span_s, (end[2] - start[2]) / span_s)
    return linear, _turn_rate(multiply(end[3:], conjugate(start[3:])), span_s)


def _turn_rate(turn: Quaternion, span_s: float) -> Vector:
    """Return the axis times the angle per second of a small rotation, in the shorter direction."""
    x, y, z, w = turn if turn[3] >= 0.0 else (-turn[0], -turn[1], -turn[2], -turn[3])
    sine = sqrt(x * x + y * y + z * z)
    if sine == 0.0:
        return (0.0, 0.0, 0.0)
    scale = 2.0 * atan2(sine, w) / sine / span_s
    return (x * scale, y * scale, z * scale)
