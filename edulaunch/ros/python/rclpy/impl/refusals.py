"""Functions that return or raise rclpy's errors, with rclpy's messages and additional help."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import kind_of, with_facts
from edulaunch.engine.underlay_place import engine_folder
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError, RMWError

if TYPE_CHECKING:
    from rclpy.impl.protocols import ContextProtocol

_OURS = (engine_folder() + os.sep, '<')


def student_level() -> int:
    """Return the `stacklevel` with which a warning of the caller shows the student's line, or 2 if there is no such line."""
    level, frame = 1, sys._getframe(1)
    while frame.f_code.co_filename.startswith(_OURS):
        if frame.f_back is None:
            return 2
        level, frame = level + 1, frame.f_back
    return level


def invalid_handle() -> InvalidHandle:
    """Return the error of ROS 2 for the use of a destroyed object."""
    return InvalidHandle('cannot use Destroyable because destruction was requested')


def after_shutdown(what: str) -> RCLError:
    """Return the error of rcl for the use of an endpoint or node after shutdown.

    The message begins with `what`, and names the node.
    """
    return with_facts(RCLError(f"{what}'s context is invalid"), 'programs.after-shutdown')


def check_node(node: Any) -> None:
    """Raise rclpy's error for an object that is not a node, such as a class, None or a list."""
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
    """Raise rclpy's error for an object that is not a future."""
    if not hasattr(future, 'add_done_callback'):
        raise with_facts(
            AttributeError(f"{type(future).__name__!r} object has no attribute 'add_done_callback'"),
            'programs.no-future',
            given=kind_of(future),
        )


def check_executor(executor: Any, attribute: str) -> None:
    """Raise rclpy's error for an object that is not an executor, such as a timeout passed by position or a class."""
    if isinstance(executor, type):
        no_self = TypeError("Executor.add_node() missing 1 required positional argument: 'node'")
        raise with_facts(no_self, 'messages.class-given', wanted=executor.__name__)
    if not hasattr(executor, 'add_node'):
        error = AttributeError(f'{type(executor).__name__!r} object has no attribute {attribute!r}')
        if isinstance(executor, (int, float)):
            raise with_facts(error, 'programs.bare-timeout', value=executor)
        raise with_facts(error, 'programs.no-executor', given=kind_of(executor))


def stopped(error: StopIteration) -> RuntimeError:
    """Return the error for a StopIteration in a callback. rclpy runs callbacks inside coroutines, which convert
    this exception.
    """
    return with_facts(RuntimeError('coroutine raised StopIteration'), 'programs.stop-iteration')


def two_spinners(error: ValueError) -> ValueError:
    """Return Python's error for two threads that spin one executor with equal arguments."""
    return with_facts(error, 'programs.two-spinners')


def no_context(context: ContextProtocol) -> Exception:
    """Return the error of rclpy for an executor that is created before init or after shutdown."""
    if context.ended_by_signal:
        return without_context('failed to create guard_condition')
    return with_facts(TypeError("'NoneType' object does not support the context manager protocol"), 'programs.no-init')


def without_context(what: str) -> RCLError:
    """Return the error of rcl for a call that uses a context after its shutdown."""
    return with_facts(
        RCLError(f'{what}: the given context is not valid, either rcl_init() was not called or rcl_shutdown() was called.'),
        'programs.after-shutdown',
    )


def check_is_text(name: Any, kind: str) -> None:
    """Raise rclpy's error for a name that is not a string.

    :param kind: 'node_name', 'namespace', 'topic_name' or 'full_topic_name'.
    :raises TypeError: for an object of any other type.
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
