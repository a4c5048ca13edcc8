"""What rclpy refuses, in its own words, with help: what executors cannot use, what is asked for before init or after the end, a
second type for one name, and names that the C layer checks.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import kind_of, with_facts
from edulaunch.engine.graph.names import expand_name, full_topic_name_problem, topic_name_problem
from edulaunch.engine.underlay_place import engine_folder
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError, RMWError

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node_parts.core import NodeCore

_OURS = (engine_folder() + os.sep, '<')


def student_level() -> int:
    """The `stacklevel` with which a warning by the caller of this names the student's line; 2 when there is none on the way."""
    level, frame = 1, sys._getframe(1)
    while frame.f_code.co_filename.startswith(_OURS):
        if frame.f_back is None:
            return 2
        level, frame = level + 1, frame.f_back
    return level


def invalid_handle() -> InvalidHandle:
    """What ROS 2 raises when something is used after it was destroyed."""
    return InvalidHandle('cannot use Destroyable because destruction was requested')


def after_shutdown(what: str) -> RCLError:
    """What rcl says of an endpoint or node after the end of its context: `what` begins the sentence and names whose that is."""
    return with_facts(RCLError(f"{what}'s context is invalid"), 'programs.after-shutdown')


def check_node(node: Any) -> None:
    """Raise what rclpy raises for a thing that is no node: a class, None, a list."""
    if isinstance(node, type):
        name = node.__name__
        raise with_facts(TypeError("'property' object is not iterable"), 'programs.spin-class', given=name)
    if not hasattr(type(node), 'executor'):
        raise with_facts(
            AttributeError(f"{type(node).__name__!r} object has no attribute 'executor'"),
            'programs.spin-no-node',
            given=kind_of(node),
        )


def check_future(future: Any) -> None:
    """Raise what rclpy raises for a thing that is no future."""
    if not hasattr(future, 'add_done_callback'):
        raise with_facts(
            AttributeError(f"{type(future).__name__!r} object has no attribute 'add_done_callback'"),
            'programs.no-future',
            given=kind_of(future),
        )


def check_executor(executor: Any, attribute: str) -> None:
    """Raise what rclpy raises for a thing that is no executor, most often a timeout without its name, or a class."""
    if isinstance(executor, type):
        no_self = TypeError("Executor.add_node() missing 1 required positional argument: 'node'")
        raise with_facts(no_self, 'messages.class-given', wanted=executor.__name__)
    if not hasattr(executor, 'add_node'):
        error = AttributeError(f'{type(executor).__name__!r} object has no attribute {attribute!r}')
        if isinstance(executor, (int, float)):
            raise with_facts(error, 'programs.bare-timeout', value=executor)
        raise with_facts(error, 'programs.no-executor', given=kind_of(executor))


def stopped(error: StopIteration) -> RuntimeError:
    """What a StopIteration in a callback becomes: rclpy runs callbacks inside coroutines, and no coroutine lets one out."""
    return with_facts(RuntimeError('coroutine raised StopIteration'), 'programs.stop-iteration')


def two_spinners(error: ValueError) -> ValueError:
    """What Python raises when two threads take from the same wait: both spin one executor, with equal arguments."""
    return with_facts(error, 'programs.two-spinners')


def no_context(context: Context) -> Exception:
    """What rclpy raises when an executor is made before init or after the end."""
    if context.ended_by_signal:
        return without_context('failed to create guard_condition')
    return with_facts(TypeError("'NoneType' object does not support the context manager protocol"), 'programs.no-init')


def without_context(what: str) -> RCLError:
    """What rcl says when something that needs a context is wanted after its end."""
    return with_facts(
        RCLError(f'{what}: the given context is not valid, either rcl_init() was not called or rcl_shutdown() was called.'),
        'programs.after-shutdown',
    )


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


def check_is_text(name: Any, kind: str) -> None:
    """Raise what rclpy raises for a name that is no text.

    :param kind: 'node_name', 'namespace', 'topic_name' or 'full_topic_name'.
    :raises TypeError: for another thing.
    :raises RMWError, RCLError: for None.
    """
    if isinstance(name, str):
        return
    if name is None and kind == 'topic_name':
        raise RCLError('failed to validate name: topic_name argument is null')
    if name is None:
        what = kind.replace('_', ' ').removeprefix('full topic ')
        raise RMWError(f'failed to validate {what}: error not set')
    raise TypeError(
        f'rclpy_get_validation_error_for_{kind}(): incompatible function arguments: '
        f'a name must be a str, not {type(name).__name__}'
    )


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
