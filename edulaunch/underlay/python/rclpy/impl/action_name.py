"""The name of an action, checked when a client or server of it is made."""

from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.facts import with_facts
from edulaunch.graph.names import expand_name, full_topic_name_problem, topic_name_problem

if TYPE_CHECKING:
    from rclpy.node_parts.core import NodeCore


def checked_action_name(core: NodeCore, name: str, kind: str) -> str:
    """The absolute name; remap rules are for the services and topics of the action.

    :param kind: 'client' or 'server'.
    :raises InvalidHandle: the node was destroyed.
    :raises ValueError: after shutdown, and for a name that breaks the rules (of other names ROS 2 says it with other classes).
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
    """What is wrong with a name, as ROS 2 sees it on the name of the action's first service."""
    if not name:
        return 'invalid empty action name'
    service = f'{name}/_action/send_goal'
    if service[0] == '~' and service[1] != '/':
        return "topic name must not have a tilde '~' that is not followed by a forward slash '/'"
    problem = topic_name_problem(service)
    if problem is None:
        try:
            problem = full_topic_name_problem(expand_name(service, core.name, core.namespace))
        except ValueError as error:  # an unknown substitution
            return str(error).partition(' is invalid: ')[2]
    return None if problem is None else problem[0]
