"""Write recorded messages as a bag folder that every rosbag2 can read. The package `rosbags` writes the files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any, Protocol

from edulaunch.engine.graph import qos
from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.interfaces.registry import Registry
from edulaunch.engine.interfaces.spec import Constant, MessageSpec
from edulaunch.ros.serialization.cdr import encode
from edulaunch.ros.serialization.type_description import type_hash

BagMessage = tuple[int, str, Any]
"""Time of arrival in ns, topic, and wire tuple; a message from a real network has its bytes instead of the tuple."""
SEPARATOR = '=' * 80


class Topic(Protocol):
    """The data about a topic that the metadata of a bag contain."""

    name: str
    cls: Any
    offered: list[qos.QoS]


def write_bag(
    folder: str,
    storage: str,
    topics: Iterable[Topic],
    messages: list[BagMessage],
    registry: Registry | None = None,
    *,
    compression: str = 'none',
    custom_data: Mapping[str, str] | None = None,
) -> None:
    """Write a bag folder with `metadata.yaml` and one storage file.

    :param folder: the path of the folder, which must not exist yet.
    :param storage: 'mcap' or 'sqlite3'.
    :param topics: the topics of the bag.
    :param messages: the messages, sorted by time.
    :param registry: contains the message types (default: all types that can be imported).
    :param compression: 'none', 'file', or 'message'.
    :param custom_data: keys and values to store in the metadata.
    """
    from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer

    registry = registry or current_registry()
    bag = Writer(folder, version=9, storage_plugin=StoragePlugin[storage.upper()])
    bag.set_compression(CompressionMode[compression.upper()], CompressionFormat.ZSTD)
    for key, value in (custom_data or {}).items():
        bag.set_custom_data(key, value)
    with bag as writer:
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
            writer.write(connection, time_ns, wire if isinstance(wire, bytes) else encode(cls, wire))
    path = os.path.join(folder, 'metadata.yaml')
    with open(path, encoding='utf-8') as file:
        text = file.read()
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text.replace('ros_distro: rosbags\n', 'ros_distro: jazzy\n'))  # rosbags writes its own name here


def definition(registry: Registry, type_name: str) -> str:
    """Return the definition of a message type and of all nested types, in the format of bag files."""
    texts: dict[str, str] = {}
    waiting = [type_name]
    while waiting:
        name = waiting.pop(0)
        if name not in texts:
            spec = registry.spec(name)
            assert isinstance(spec, MessageSpec)
            texts[name] = '\n'.join(
                [*map(_constant, spec.constants), *(f'{_short(field.type.text)} {field.name}' for field in spec.fields)]
            )
            waiting += [field.type.base for field in spec.fields if field.type.kind is None]
    own = texts.pop(type_name)
    return '\n'.join([own, *(f'{SEPARATOR}\nMSG: {_short(name)}\n{text}' for name, text in texts.items())])


def _constant(constant: Constant) -> str:
    value = constant.value
    if isinstance(value, bytes):
        value = value[0]
    return f'{constant.base} {constant.name}={str(value).lower() if isinstance(value, bool) else repr(value)}'


def _short(name: str) -> str:
    """Return the short name of a type that bag files use, such as 'geometry_msgs/Point' for 'geometry_msgs/msg/Point'."""
    return name.replace('/msg/', '/')


def _offered(qos: qos.QoS) -> Any:
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
