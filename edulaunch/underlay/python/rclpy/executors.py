"""Executors: they wait until something is ready, and call the callbacks."""
from __future__ import annotations

from rclpy.execution.exceptions import (
    ConditionReachedException,
    ExternalShutdownException,
    ShutdownException,
    TimeoutException,
)
from rclpy.execution.executor import Executor, TimeoutObject
from rclpy.execution.multi_threaded import MultiThreadedExecutor
from rclpy.execution.single_threaded import SingleThreadedExecutor

__all__ = [
    'ConditionReachedException', 'Executor', 'ExternalShutdownException', 'MultiThreadedExecutor', 'ShutdownException',
    'SingleThreadedExecutor', 'TimeoutException', 'TimeoutObject',
]
