"""Writing a bag folder that any rosbag2 reads, with `rosbags`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Protocol

from edulaunch.cli.ros2.bag.topic import BagMessage
from edulaunch.graph.qos import QoS
from edulaunch.interfaces import current_registry
from edulaunch.interfaces.cdr import encode
from edulaunch.interfaces.description import type_hash
from edulaunch.interfaces.registry import Registry
from edulaunch.interfaces.spec import Constant, FieldType, MessageSpec

SEPARATOR = '=' * 80


class Topic(Protocol):
    """What a bag says of a topic."""

    name: str
    cls: Any
    offered: list[QoS]


def write_bag(
    folder: str, storage: str, topics: Iterable[Topic], messages: list[BagMessage], registry: Registry | None = None
) -> None:
    """Write `metadata.yaml` and one storage file.

    :param folder: to be made; must not exist.
    :param storage: 'mcap' or 'sqlite3'.
    :param messages: in order of time.
    :param registry: of the message types (default: those that can be imported).
    """
    from rosbags.rosbag2 import StoragePlugin, Writer

    registry = registry or current_registry()
    with Writer(folder, version=9, storage_plugin=StoragePlugin[storage.upper()]) as writer:
        connections = {}
        for topic in topics:
            kind = topic.cls.TYPE
            connections[topic.name] = (
                topic.cls,
                writer.add_connection(
                    topic.name,
                    kind,
                    msgdef=definition(registry, kind),
                    rihs01=type_hash(kind, registry.spec),
                    offered_qos_profiles=[_offered(each) for each in topic.offered],
                ),
            )
        for time_ns, name, wire in messages:
            cls, connection = connections[name]
            writer.write(connection, time_ns, encode(cls, wire))


def definition(registry: Registry, type_name: str) -> str:
    """The text of a message and of all messages in it, as bag files carry it."""
    texts: dict[str, str] = {}
    waiting = [type_name]
    while waiting:
        name = waiting.pop(0)
        if name not in texts:
            spec = registry.spec(name)
            assert isinstance(spec, MessageSpec)
            texts[name] = '\n'.join(
                [*map(_constant, spec.constants), *(f'{_type(field.type)} {field.name}' for field in spec.fields)]
            )
            waiting += [field.type.base for field in spec.fields if field.type.kind is None]
    own = texts.pop(type_name)
    return '\n'.join([own, *(f'{SEPARATOR}\nMSG: {_short(name)}\n{text}' for name, text in texts.items())])


def _constant(constant: Constant) -> str:
    value = constant.value
    if isinstance(value, bytes):
        value = value[0]
    return f'{constant.base} {constant.name}={str(value).lower() if isinstance(value, bool) else repr(value)}'


def _type(field_type: FieldType) -> str:
    return _short(field_type.text)


def _short(name: str) -> str:
    """'geometry_msgs/msg/Point' as bag files write it."""
    return name.replace('/msg/', '/')


def _offered(qos: QoS) -> Any:
    from rosbags import interfaces

    def finite(nanoseconds: int) -> Any:
        return interfaces.QosTime(*divmod(nanoseconds or (1 << 63) - 1, 1_000_000_000))

    return interfaces.Qos(
        interfaces.QosHistory[qos.history.upper()],
        qos.depth,
        interfaces.QosReliability[qos.reliability.upper()],
        interfaces.QosDurability[qos.durability.upper()],
        finite(qos.deadline_ns),
        finite(qos.lifespan_ns),
        interfaces.QosLiveliness[qos.liveliness.upper()],
        finite(qos.lease_ns),
        False,
    )
