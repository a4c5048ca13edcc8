"""What executors are given or get that they cannot use: rclpy's own errors, with help."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._rclpy_pybind11 import RCLError
from rclpy.impl.hints import SHUT_DOWN, hinted

if TYPE_CHECKING:
    from rclpy.context import Context


def check_node(node: Any) -> None:
    """Raise what rclpy raises for a thing that is no node: a class, None, a list."""
    if isinstance(node, type):
        name = node.__name__
        raise hinted(TypeError("'property' object is not iterable"), f'{name} is a class; make a node of it: {name}()')
    if not hasattr(type(node), 'executor'):
        raise hinted(AttributeError(f"{type(node).__name__!r} object has no attribute 'executor'"), 'a node is needed here')


def check_future(future: Any) -> None:
    """Raise what rclpy raises for a thing that is no future."""
    if not hasattr(future, 'add_done_callback'):
        raise hinted(
            AttributeError(f"{type(future).__name__!r} object has no attribute 'add_done_callback'"),
            'a future is needed here, such as client.call_async(request) gives',
        )


def check_executor(executor: Any, attribute: str) -> None:
    """Raise what rclpy raises for a thing that is no executor, most often a timeout without its name."""
    if not hasattr(executor, 'add_node'):
        hint = f'write timeout_sec={executor}' if isinstance(executor, (int, float)) else 'an executor is needed here'
        raise hinted(AttributeError(f'{type(executor).__name__!r} object has no attribute {attribute!r}'), hint)


def stopped(error: StopIteration) -> RuntimeError:
    """What a StopIteration in a callback becomes: rclpy runs callbacks inside coroutines, and no coroutine lets one out."""
    return hinted(RuntimeError('coroutine raised StopIteration'), 'next() found nothing more; write next(values, None)')


def two_spinners(error: ValueError) -> ValueError:
    """What Python raises when two threads take from the same wait: both spin one executor, with equal arguments."""
    return hinted(
        error,
        'another thread spins this executor already; give this one its own: '
        'rclpy.spin(node, rclpy.executors.SingleThreadedExecutor())',
    )


def no_context(context: Context) -> Exception:
    """What rclpy raises when an executor is made before init or after the end."""
    if context.ended_by_signal:
        return without_context('create guard_condition')
    return hinted(
        TypeError("'NoneType' object does not support the context manager protocol"),
        f'{SHUT_DOWN}; spin before that' if context.used else 'call rclpy.init() first',
    )


def without_context(what: str) -> RCLError:
    """What rcl says when something that needs a context is wanted after its end."""
    return hinted(
        RCLError(
            f'failed to {what}: the given context is not valid, either rcl_init() was not called or rcl_shutdown() was called.'
        ),
        SHUT_DOWN,
    )
