"""Presets by name, the numbers of policies, whether two profiles suit each other. Programs find it all in `rclpy.qos`."""
from __future__ import annotations

from enum import Enum, IntEnum
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.graph import qos as engine
from rclpy.qos import (
    QoSProfile,
    engine_qos,
    qos_profile_action_status_default,
    qos_profile_best_available,
    qos_profile_default,
    qos_profile_parameter_events,
    qos_profile_parameters,
    qos_profile_sensor_data,
    qos_profile_services_default,
    qos_profile_system_default,
    qos_profile_unknown,
)

if TYPE_CHECKING:
    from edulaunch.graph.qos import QoS


class QoSPolicyKind(IntEnum):
    """The policies, as incompatibility events number them."""

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


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    """The name of a policy, such as 'RELIABILITY'."""
    return QoSPolicyKind(policy_kind).name


class QoSPresetProfiles(Enum):
    """The profiles that ROS 2 brings along."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    BEST_AVAILABLE = qos_profile_best_available
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default

    @classmethod
    def short_keys(cls) -> list[str]:
        """All short keys, such as 'sensor_data'."""
        return [name.lower() for name in cls.__members__ if name != 'UNKNOWN']

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """The profile of a short key. Raises KeyError for an unknown one."""
        profile: QoSProfile = cls[name.upper()].value
        return profile


class QoSCompatibility(IntEnum):
    """Whether two profiles suit each other."""

    OK = 0
    WARNING = 1
    ERROR = 2


class QoSCheck(NamedTuple):
    """What :func:`qos_check_compatible` found."""

    compatibility: QoSCompatibility
    reason: str


def qos_check_compatible(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> QoSCheck:
    """Whether a publisher and a subscription with these profiles can talk, and the reasons why not."""
    errors = list(_clashes(engine_qos(publisher_qos), engine_qos(subscription_qos)))
    if errors:
        return QoSCheck(QoSCompatibility.ERROR, ''.join(f'ERROR: {reason};' for reason in errors))
    doubts = [name.capitalize() for name in ('reliability', 'durability', 'liveliness')
              if 'SYSTEM_DEFAULT' in (getattr(publisher_qos, name).name, getattr(subscription_qos, name).name)
              and getattr(publisher_qos, name) != getattr(subscription_qos, name) and name != 'liveliness']
    if doubts:
        reason = ''.join(f'WARNING: {name} of one side is the system default;' for name in doubts)
        return QoSCheck(QoSCompatibility.WARNING, reason)
    return QoSCheck(QoSCompatibility.OK, '')


def _clashes(offered: QoS, requested: QoS) -> list[str]:
    same = offered._replace(depth=requested.depth)
    found = []
    for fields, reason in (
            (('reliability',), 'Best effort publisher and reliable subscription'),
            (('durability',), 'Volatile publisher and transient local subscription'),
            (('deadline_ns',), 'Subscription has a deadline, but publisher does not' if not offered.deadline_ns
             else 'Subscription deadline is less than publisher deadline'),
            (('liveliness',), "Publisher's liveliness is automatic and subscription's is manual by topic"),
            (('lease_ns',), 'Subscription has a liveliness lease duration, but publisher does not' if not offered.lease_ns
             else "Subscription's liveliness lease duration is less than publisher's")):
        if engine.incompatible_policy(offered, same._replace(**{field: getattr(requested, field) for field in fields})):
            found.append(reason)
    return found
