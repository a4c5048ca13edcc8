"""The parts of `rclpy.executors`: what waits, what executes, and the threads of the multi-threaded one."""

from __future__ import annotations
