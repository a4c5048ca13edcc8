"""The module of the C layer's errors, by the name under which rclpy reaches it."""

from __future__ import annotations

from rclpy import _rclpy_pybind11 as rclpy_implementation

__all__ = ['rclpy_implementation']
