"""One program cannot use one name for two types: Fast DDS refuses the second."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.facts import with_facts
from rclpy._rclpy_pybind11 import RCLError

if TYPE_CHECKING:
    from rclpy.node_parts.core import NodeCore


def check_new_topic_end(core: NodeCore, name: str, msg_type: Any, kind: str) -> None:
    """Check that a publisher or subscription can be made.

    :param kind: 'publisher' or 'subscription'.
    :raises RCLError: after shutdown, or when an endpoint of this program uses the topic with another type.
    """
    core.check_usable(f'Failed to create {kind}')
    graph = core.graph
    other = _of_another_type(core, [*graph.publishers.get(name, ()), *graph.subscriptions.get(name, ())], msg_type)
    if other is not None:
        reason = (
            f'create_publisher() called for existing topic name rt{name} with incompatible type {_dds_name(msg_type)}_'
            if kind == 'publisher'
            else 'invalid allocator'
        )
        raise with_facts(
            RCLError(f'Failed to create {kind}: {reason}'), 'messages.two-types', **_clash('topic', name, msg_type, other)
        )


def check_new_service_end(core: NodeCore, name: str, srv_type: Any, kind: str) -> None:
    """Check that a service or client can be made.

    :param kind: 'service' or 'client'.
    :raises RCLError: after shutdown, or when this program uses the service with another type.
    """
    core.check_usable(f'failed to create {kind}')
    graph = core.graph
    other = _of_another_type(core, [*graph.services.get(name, ()), *graph.clients.get(name, ())], srv_type)
    if other is not None:
        raise with_facts(
            RCLError(
                f'failed to create {kind}: create_{kind}() called for existing request topic name rq{name}Request '
                f'with incompatible type {_dds_name(srv_type)}_Request_'
            ),
            'messages.two-types',
            **_clash('service', name, srv_type, other),
        )


def _of_another_type(core: NodeCore, ends: list[Any], wanted: Any) -> Any:
    if core.takes_any_type:
        return None
    participant = core.entry.participant
    for end in ends:
        if end.type_name != wanted.TYPE and end.node.participant is participant:
            return end
    return None


def _dds_name(cls: Any) -> str:
    package, folder, name = cls.TYPE.split('/')
    return f'{package}::{folder}::dds_::{name}'


def _clash(kind: str, name: str, wanted: Any, other: Any) -> dict[str, str]:
    return {
        'end': kind,
        'used_name': name,
        'node': other.node.fully_qualified_name,
        'used': other.type_name,
        'wanted': wanted.TYPE,
    }
