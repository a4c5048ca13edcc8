"""What graph queries tell about one publisher or subscription."""
from __future__ import annotations

from enum import IntEnum
from typing import Any

from rclpy.impl.passed_on import passed_on
from rclpy.qos import QoSHistoryPolicy, QoSProfile, profile_from_engine
from rclpy.type_hash import TypeHash


class TopicEndpointTypeEnum(IntEnum):
    """Which side of a topic."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


class TopicEndpointInfo:
    """One endpoint of a topic."""

    def __init__(self, endpoint: Any) -> None:
        self._endpoint = endpoint

    @property
    def node_name(self) -> str:
        """The own name of its node."""
        name: str = self._endpoint.node.name
        return name

    @property
    def node_namespace(self) -> str:
        """The namespace of its node."""
        namespace: str = self._endpoint.node.namespace
        return namespace

    @property
    def topic_type(self) -> str:
        """Its type, such as 'std_msgs/msg/String'."""
        name: str = self._endpoint.type_name
        return name

    @property
    def topic_type_hash(self) -> TypeHash:
        """The hash of its type."""
        from edulaunch.interfaces import current_registry
        from edulaunch.interfaces.description import type_hash
        return TypeHash(type_hash(self.topic_type, current_registry().spec))

    @property
    def endpoint_type(self) -> TopicEndpointTypeEnum:
        """Publisher or subscription."""
        return TopicEndpointTypeEnum[self._endpoint.kind.upper()]

    @property
    def endpoint_gid(self) -> list[int]:
        """A number of its own, as 16 bytes."""
        return list(self._endpoint.index.to_bytes(16, 'big'))

    @property
    def qos_profile(self) -> QoSProfile:
        """Its quality of service."""
        return profile_from_engine(self._endpoint.qos)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TopicEndpointInfo) and self._endpoint is other._endpoint

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        gid = '.'.join(format(byte, '02x') for byte in self.endpoint_gid)
        return '\n'.join((
            f'Node name: {self.node_name}', f'Node namespace: {self.node_namespace}', f'Topic type: {self.topic_type}',
            f'Topic type hash: {self.topic_type_hash}', f'Endpoint type: {self.endpoint_type.name}', f'GID: {gid}',
            'QoS profile:', *_profile_lines(self.qos_profile)))


def _profile_lines(profile: QoSProfile) -> list[str]:
    depth = f' ({profile.depth})' if profile.history == QoSHistoryPolicy.KEEP_LAST else ''

    def duration(value: Any) -> str:
        return 'Infinite' if value.nanoseconds == (1 << 63) - 1 else f'{value.nanoseconds} nanoseconds'

    return [
        f'  Reliability: {profile.reliability.name}', f'  History (Depth): {profile.history.name}{depth}',
        f'  Durability: {profile.durability.name}', f'  Lifespan: {duration(profile.lifespan)}',
        f'  Deadline: {duration(profile.deadline)}', f'  Liveliness: {profile.liveliness.name}',
        f'  Liveliness lease duration: {duration(profile.liveliness_lease_duration)}']


def endpoint_info(endpoint: Any) -> TopicEndpointInfo:
    """The info of an endpoint of the graph."""
    return TopicEndpointInfo(endpoint)


__getattr__ = passed_on(__name__, {
    'rclpy.qos': 'QoSPresetProfiles',
})
