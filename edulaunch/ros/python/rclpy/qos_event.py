"""The old name of `rclpy.event_handler`. ROS 2 warns about it once in each process, but processes share modules here."""

from __future__ import annotations

from edulaunch.ros.passed_on import passed_on

__getattr__ = passed_on(__name__)
