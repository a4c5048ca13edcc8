"""Experimental features of ROS 2."""

from __future__ import annotations

from rclpy.experimental.events_executor import EventsExecutor

__all__ = ['EventsExecutor']
