"""What executors are given or get that they cannot use: rclpy's own errors, with help."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.facts import kind_of, with_facts
from rclpy._rclpy_pybind11 import RCLError

if TYPE_CHECKING:
    from rclpy.context import Context


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
        return without_context('create guard_condition')
    return with_facts(TypeError("'NoneType' object does not support the context manager protocol"), 'programs.no-init')


def without_context(what: str) -> RCLError:
    """What rcl says when something that needs a context is wanted after its end."""
    return with_facts(
        RCLError(
            f'failed to {what}: the given context is not valid, either rcl_init() was not called or rcl_shutdown() was called.'
        ),
        'programs.after-shutdown',
    )
