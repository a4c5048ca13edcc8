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


__getattr__ = passed_on(__name__)
