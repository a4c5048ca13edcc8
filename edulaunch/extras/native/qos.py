"""Convert quality of service between edulaunch's classes and the real rclpy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

FOREVER_NS = 2**62
"""The longest finite duration. rclpy's value for an infinite duration is larger."""


def to_rclpy(row: Sequence[Any]) -> QoSProfile:
    """Return the profile of the real rclpy for a profile of edulaunch, which is given as a sequence of policies."""
    depth, reliability, durability, history, deadline_ns, lifespan_ns, liveliness, lease_ns = row
    return QoSProfile(
        depth=max(1, depth),
        reliability=ReliabilityPolicy[reliability.upper()],
        durability=DurabilityPolicy[durability.upper()],
        history=HistoryPolicy[history.upper()],
        deadline=Duration(nanoseconds=deadline_ns),
        lifespan=Duration(nanoseconds=lifespan_ns),
        liveliness=LivelinessPolicy[liveliness.upper()],
        liveliness_lease_duration=Duration(nanoseconds=lease_ns),
    )


def from_rclpy(profile: QoSProfile) -> list[Any]:
    """Return the profile of edulaunch for a profile of the real rclpy. Unknown policies of a remote endpoint get the default."""
    history = profile.history.name.lower()
    durations = (profile.deadline, profile.lifespan, profile.liveliness_lease_duration)
    times = [each.nanoseconds if each.nanoseconds < FOREVER_NS else 0 for each in durations]
    return [
        profile.depth or 10,
        profile.reliability.name.lower(),
        profile.durability.name.lower(),
        history if history != 'unknown' else 'keep_last',
        times[0],
        times[1],
        profile.liveliness.name.lower(),
        times[2],
    ]
