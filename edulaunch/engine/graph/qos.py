"""Quality of service: the policies of an endpoint, and when two endpoints are compatible."""

from __future__ import annotations

from typing import NamedTuple

RELIABLE, BEST_EFFORT = 'reliable', 'best_effort'
VOLATILE, TRANSIENT_LOCAL = 'volatile', 'transient_local'
KEEP_LAST, KEEP_ALL = 'keep_last', 'keep_all'
AUTOMATIC, MANUAL_BY_TOPIC = 'automatic', 'manual_by_topic'
INFINITE_NS = 0
"""As in rmw, 0 ns means that an endpoint has no deadline, lifespan or lease."""


class QoS(NamedTuple):
    """The QoS policies of one endpoint. Times are in nanoseconds, and 0 means infinite.

    All values are resolved: `rclpy` replaces system defaults and `best_available` before it creates an endpoint.
    """

    depth: int = 10
    reliability: str = RELIABLE
    durability: str = VOLATILE
    history: str = KEEP_LAST
    deadline_ns: int = INFINITE_NS
    lifespan_ns: int = INFINITE_NS
    liveliness: str = AUTOMATIC
    lease_ns: int = INFINITE_NS

    @property
    def queue_length(self) -> int | None:
        """The number of messages that a queue of this endpoint can contain, or None for no limit."""
        return None if self.history == KEEP_ALL else max(1, self.depth)


def incompatible_policy(offered: QoS, requested: QoS) -> str | None:
    """Return the ROS 2 name of the policy that makes a publisher and a subscription incompatible, or None if they are
    compatible.

    Each offered policy must be at least as good as the requested policy; history and depth never matter (facts_rclpy.md
    section 9). If several policies are incompatible, return the policy that Fast DDS reports last.
    """
    if offered.reliability == BEST_EFFORT and requested.reliability == RELIABLE:
        return 'RELIABILITY'
    if offered.liveliness == AUTOMATIC and requested.liveliness == MANUAL_BY_TOPIC:
        return 'LIVELINESS'
    if requested.lease_ns and not 0 < offered.lease_ns <= requested.lease_ns:
        return 'LIVELINESS'
    if requested.deadline_ns and not 0 < offered.deadline_ns <= requested.deadline_ns:
        return 'DEADLINE'
    if offered.durability == VOLATILE and requested.durability == TRANSIENT_LOCAL:
        return 'DURABILITY'
    return None
