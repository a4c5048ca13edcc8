"""The information about one publisher or subscription that graph queries return."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from edulaunch.engine.interfaces import current_registry
from edulaunch.errors import InterfaceError
from edulaunch.ros.passed_on import passed_on
from rclpy.qos import QoSHistoryPolicy, QoSProfile, profile_from_engine, qos_profile_unknown
from rclpy.type_hash import TypeHash


class TopicEndpointTypeEnum(IntEnum):
    """The kinds of endpoints of a topic."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


def _text(value: Any) -> str:
    assert isinstance(value, str)
    return value


def _type_hash(value: Any) -> TypeHash:
    if isinstance(value, dict):
        value = TypeHash(**value)
    assert isinstance(value, TypeHash)
    return value


def _side(value: Any) -> TopicEndpointTypeEnum:
    assert isinstance(value, int)
    return TopicEndpointTypeEnum(value)


def _bytes(value: Any) -> list[int]:
    assert all(isinstance(byte, int) for byte in value)
    checked: list[int] = value
    return checked


def _profile(value: Any) -> QoSProfile:
    if isinstance(value, dict):
        value = QoSProfile(**value)
    assert isinstance(value, QoSProfile)
    return value


_FIELDS: dict[str, tuple[Callable[[], Any], Callable[[Any], Any]]] = {
    'node_name': (str, _text),
    'node_namespace': (str, _text),
    'topic_type': (str, _text),
    'topic_type_hash': (TypeHash, _type_hash),
    'endpoint_type': (lambda: TopicEndpointTypeEnum.INVALID, _side),
    'endpoint_gid': (list, _bytes),
    'qos_profile': (lambda: qos_profile_unknown, _profile),
}
"""The fields of an endpoint, each with its default and the check of its value."""


class TopicEndpointInfo:
    """One endpoint of a topic: its node, type, kind, identifier (16 bytes) and QoS.

    :raises AssertionError: for an unknown keyword or a value of the wrong type.
    """

    __slots__ = tuple('_' + name for name in _FIELDS)

    if TYPE_CHECKING:
        node_name: str
        node_namespace: str
        topic_type: str
        topic_type_hash: TypeHash
        endpoint_type: TopicEndpointTypeEnum
        endpoint_gid: list[int]
        qos_profile: QoSProfile

    def __init__(self, **kwargs: Any) -> None:
        assert kwargs.keys() <= _FIELDS.keys(), f'Invalid arguments passed to constructor: {kwargs.keys()!r}'
        for name, (default, _) in _FIELDS.items():
            setattr(self, name, kwargs[name] if name in kwargs else default())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TopicEndpointInfo) and all(
            getattr(self, slot) == getattr(other, slot) for slot in self.__slots__
        )

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        gid = '.'.join(format(byte, '02x') for byte in self.endpoint_gid)
        return '\n'.join(
            (
                f'Node name: {self.node_name}',
                f'Node namespace: {self.node_namespace}',
                f'Topic type: {self.topic_type}',
                f'Topic type hash: {self.topic_type_hash}',
                f'Endpoint type: {self.endpoint_type.name}',
                f'GID: {gid}',
                'QoS profile:',
                *_profile_lines(self.qos_profile),
            )
        )


def _profile_lines(profile: QoSProfile) -> list[str]:
    depth = f' ({profile.depth})' if profile.history == QoSHistoryPolicy.KEEP_LAST else ''

    def duration(value: Any) -> str:
        return 'Infinite' if value.nanoseconds == (1 << 63) - 1 else f'{value.nanoseconds} nanoseconds'

    return [
        f'  Reliability: {profile.reliability.name}',
        f'  History (Depth): {profile.history.name}{depth}',
        f'  Durability: {profile.durability.name}',
        f'  Lifespan: {duration(profile.lifespan)}',
        f'  Deadline: {duration(profile.deadline)}',
        f'  Liveliness: {profile.liveliness.name}',
        f'  Liveliness lease duration: {duration(profile.liveliness_lease_duration)}',
    ]


def _property(name: str, check: Callable[[Any], Any]) -> property:
    slot = '_' + name

    def getter(self: TopicEndpointInfo) -> Any:
        """Return the value of this field."""
        return getattr(self, slot)

    def setter(self: TopicEndpointInfo, value: Any) -> None:
        setattr(self, slot, check(value))

    return property(getter, setter)


for _name, (_, _check) in _FIELDS.items():
    setattr(TopicEndpointInfo, _name, _property(_name, _check))


def endpoint_info(endpoint: Any) -> TopicEndpointInfo:
    """Return the information about an endpoint of the graph."""
    return TopicEndpointInfo(
        node_name=endpoint.node.name,
        node_namespace=endpoint.node.namespace,
        topic_type=endpoint.type_name,
        topic_type_hash=_hash_of(endpoint.type_name),
        endpoint_type=TopicEndpointTypeEnum[endpoint.kind.upper()],
        endpoint_gid=list(endpoint.index.to_bytes(16, 'big')),
        qos_profile=profile_from_engine(endpoint.qos),
    )


def _hash_of(type_name: str) -> TypeHash:
    """Return the hash of a type, or an empty hash if only another program's workspace contains the type."""
    from edulaunch.ros.serialization.type_description import type_hash

    try:
        text = type_hash(type_name, current_registry().spec)
    except InterfaceError:
        return TypeHash()
    return TypeHash(1, bytes.fromhex(text.partition('_')[2]))


__getattr__ = passed_on(__name__)
