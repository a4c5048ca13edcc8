"""Checks of new endpoints, with rclpy's messages and additional help. The checks find a second type for one name, and invalid
action names.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.graph.names import expand_name, full_topic_name_problem, topic_name_problem
from rclpy._rclpy_pybind11 import RCLError

if TYPE_CHECKING:
    from rclpy.node_parts.core import NodeCore


def check_new_topic_end(core: NodeCore, name: str, msg_type: Any, kind: str) -> None:
    """Check that a publisher or subscription can be created.

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
    """Check that a service or client can be created.

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


def checked_action_name(core: NodeCore, name: str, kind: str) -> str:
    """Return the absolute name of an action, not remapped. Remapping rules apply to the services and topics of the action.

    :param kind: 'client' or 'server'.
    :raises InvalidHandle: when the node was destroyed.
    :raises ValueError: after shutdown, and for an invalid or missing name. For an invalid topic or service name, ROS 2 raises
        InvalidTopicNameException or InvalidServiceNameException.
    :raises TypeError: if the name is not a string.
    """
    core.check_alive()
    failed = f'Failed to create action {kind}'
    if not core.context.alive:
        raise with_facts(ValueError(f"{failed}: rcl node's context is invalid"), 'programs.after-shutdown')
    if name is None:
        raise ValueError(f'{failed}: action_name argument is null')
    if not isinstance(name, str):
        raise TypeError(f'__init__(): incompatible constructor arguments: action_name must be a str, not {type(name).__name__}')
    if not name and kind == 'client':
        raise with_facts(ValueError(f'{failed}: failed to get goal service name'), 'programs.empty-action-name')
    problem = _problem(core, name)
    if problem is not None:
        colons = ' : ' if kind == 'client' else ' : : '
        raise ValueError(f"{failed} due to invalid topic name '{name}'{colons}{problem}")
    return expand_name(name, core.name, core.namespace)


def _problem(core: NodeCore, name: str) -> str | None:
    """Return the problem with an action name, as ROS 2 reports it for the name of the action's first service."""
    if not name:
        return 'invalid empty action name'
    service = f'{name}/_action/send_goal'
    if service[0] == '~' and service[1] != '/':
        return "topic name must not have a tilde '~' that is not followed by a forward slash '/'"
    problem = topic_name_problem(service)
    if problem is None:
        try:
            problem = full_topic_name_problem(expand_name(service, core.name, core.namespace))
        except ValueError as error:  # the substitution is unknown
            return str(error).partition(' is invalid: ')[2]
    return None if problem is None else problem[0]
