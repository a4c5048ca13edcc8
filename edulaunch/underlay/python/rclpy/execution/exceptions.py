"""How a wait ends without anything to execute. Known to programs as names of `rclpy.executors`."""

from __future__ import annotations


class TimeoutException(Exception):
    """Nothing was ready in time."""

    __module__ = 'rclpy.executors'


class ShutdownException(Exception):
    """The executor was shut down while it waited."""

    __module__ = 'rclpy.executors'


class ExternalShutdownException(Exception):
    """ROS 2 was shut down from outside (a signal, another thread) while an executor waited."""

    __module__ = 'rclpy.executors'


class ConditionReachedException(Exception):
    """What was waited for happened."""

    __module__ = 'rclpy.executors'
