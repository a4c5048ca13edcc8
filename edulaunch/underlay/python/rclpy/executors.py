"""Executors: they wait until something is ready, and call the callbacks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.execution.exceptions import ConditionReachedException, ExternalShutdownException, ShutdownException, TimeoutException
from rclpy.execution.executor import Executor, TimeoutObject
from rclpy.execution.multi_threaded import MultiThreadedExecutor
from rclpy.execution.single_threaded import SingleThreadedExecutor
from rclpy.impl.passed_on import passed_on
from rclpy.task import is_coroutine_function

__all__ = [
    'ConditionReachedException',
    'Executor',
    'ExternalShutdownException',
    'MultiThreadedExecutor',
    'ShutdownException',
    'SingleThreadedExecutor',
    'TimeoutException',
    'TimeoutObject',
    'await_or_execute',
]


async def await_or_execute(callback: Callable[..., Any], *args: Any) -> Any:
    """Call a function, or await what an `async def` one gives: for executors and waitables of one's own."""
    result = callback(*args)
    return await result if is_coroutine_function(callback) else result


__getattr__ = passed_on(
    __name__,
    {
        'typing': 'Any Callable Coroutine Dict Generator List Optional Set Tuple TypeVar Union',
        'inspect': '',
        'os': '',
        'concurrent.futures': 'ThreadPoolExecutor',
        'contextlib': 'ExitStack',
        'rclpy.client': 'Client',
        'rclpy.clock': 'Clock ClockType',
        'rclpy.context': 'Context',
        'rclpy.duration': 'Duration',
        'rclpy.exceptions': 'InvalidHandle',
        'rclpy.guard_condition': 'GuardCondition',
        'rclpy.handle': '',
        'rclpy.impl.implementation_singleton': '_rclpy=rclpy_implementation',
        'rclpy.node': 'Node',
        'rclpy.service': 'Service',
        'rclpy.signals': 'SignalHandlerGuardCondition',
        'rclpy.subscription': 'Subscription',
        'rclpy.task': 'Future Task',
        'rclpy.timer': 'Timer',
        'rclpy.utilities': 'get_default_context timeout_sec_to_nsec',
        'rclpy.waitable': 'NumberOfEntities Waitable',
    },
)
