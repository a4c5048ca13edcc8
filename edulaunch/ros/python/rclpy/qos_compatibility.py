"""The numbers of policies, and the check whether two profiles are compatible. Programs import these names from `rclpy.qos`."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING, Any

from rclpy.impl.c_enum import CEnum

if TYPE_CHECKING:
    from rclpy.qos import QoSProfile


class QoSPolicyKind(IntEnum):
    """The policies, with the numbers that incompatibility events use."""

    INVALID = 1 << 0
    DURABILITY = 1 << 1
    DEADLINE = 1 << 2
    LIVELINESS = 1 << 3
    RELIABILITY = 1 << 4
    HISTORY = 1 << 5
    LIFESPAN = 1 << 6
    DEPTH = 1 << 7
    LIVELINESS_LEASE_DURATION = 1 << 8
    AVOID_ROS_NAMESPACE_CONVENTIONS = 1 << 9


PolicyKindOfEvent: Any = CEnum(  # type: ignore[call-arg]  # has the name and numbers of C, because events have them, too
    'rmw_qos_policy_kind_t',  # type: ignore[arg-type]
    {f'RMW_QOS_POLICY_{kind.name}': kind.value for kind in QoSPolicyKind},
)


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """Return the name of a policy, such as 'RELIABILITY'."""
    return QoSPolicyKind(policy_kind).name


class QoSCompatibility(CEnum):
    """Whether two profiles are compatible."""

    OK = 0
    WARNING = 1
    ERROR = 2


# For each policy: its name in messages about both sides (with ROS 2's own spelling). Then follow the strictest value of a
# subscription and the most lenient value of a publisher. The messages are for the case that only one side sets the policy.
_OPEN_POLICIES = (
    (
        'reliability',
        'reliability',
        'RELIABLE',
        'BEST_EFFORT',
        'Reliable subscription, but publisher is {}',
        'Best effort publisher, but subscription is {}',
    ),
    (
        'durability',
        'durabilty',
        'TRANSIENT_LOCAL',
        'VOLATILE',
        'Transient local subscription, but publisher is {}',
        'Volatile publisher, but subscription is {}',
    ),
    (
        'liveliness',
        'liveliness',
        'MANUAL_BY_TOPIC',
        'AUTOMATIC',
        "Subscription's liveliness is manual by topic, but publisher's is {}",
        "Publisher's liveliness is automatic, but subscription's is {}",
    ),
)
_OPEN = ('SYSTEM_DEFAULT', 'UNKNOWN')


def qos_check_compatible(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> tuple[QoSCompatibility, str]:
    """Return whether a publisher and a subscription with these profiles can communicate, and the reasons if they cannot.

    A policy that one profile leaves open (system default, unknown) causes a warning if its value matters.
    """
    errors = _clashes(publisher_qos, subscription_qos)
    if errors:
        return QoSCompatibility.ERROR, ''.join(f'ERROR: {reason};' for reason in errors)
    doubts = _doubts(publisher_qos, subscription_qos)
    if doubts:
        return QoSCompatibility.WARNING, ''.join(f'WARNING: {reason};' for reason in doubts)
    return QoSCompatibility.OK, ''


def _doubts(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> list[str]:
    found = []
    for name, spelling, strict, lax, subscription_words, publisher_words in _OPEN_POLICIES:
        offered, requested = getattr(publisher_qos, name), getattr(subscription_qos, name)
        if offered.name in _OPEN and requested.name in _OPEN:
            found.append(f'Publisher {spelling} is {offered.short_key} and subscription {name} is {requested.short_key}')
        elif offered.name in _OPEN and requested.name == strict:
            found.append(subscription_words.format(offered.short_key))
        elif offered.name == lax and requested.name in _OPEN:
            found.append(publisher_words.format(requested.short_key))
    return found


def _clashes(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> list[str]:
    offered, requested = publisher_qos.get_c_qos_profile().resolved, subscription_qos.get_c_qos_profile().resolved
    found = []
    if (publisher_qos.reliability.name, subscription_qos.reliability.name) == ('BEST_EFFORT', 'RELIABLE'):
        found.append('Best effort publisher and reliable subscription')
    if (publisher_qos.durability.name, subscription_qos.durability.name) == ('VOLATILE', 'TRANSIENT_LOCAL'):
        found.append('Volatile publisher and transient local subscription')
    if requested.deadline_ns and not offered.deadline_ns:
        found.append('Subscription has a deadline, but publisher does not')
    elif requested.deadline_ns and requested.deadline_ns < offered.deadline_ns:
        found.append('Subscription deadline is less than publisher deadline')
    if (publisher_qos.liveliness.name, subscription_qos.liveliness.name) == ('AUTOMATIC', 'MANUAL_BY_TOPIC'):
        found.append("Publisher's liveliness is automatic and subscription's is manual by topic")
    if requested.lease_ns and not offered.lease_ns:
        found.append('Subscription has a liveliness lease duration, but publisher does not')
    elif requested.lease_ns and requested.lease_ns < offered.lease_ns:
        found.append('Subscription liveliness lease duration is less than publisher')
    return found
