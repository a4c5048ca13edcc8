"""The executor that most programs use."""

from __future__ import annotations

from rclpy.execution.executor import Executor


class SingleThreadedExecutor(Executor):
    """Executes one callback after the other, in the thread that spins."""

    __module__ = 'rclpy.executors'
