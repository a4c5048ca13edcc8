"""The older name of `rclpy.event_handler`; ROS 2 warns of it, once in each process, and modules are shared by processes here."""

from __future__ import annotations

from edulaunch.ros.passed_on import passed_on

__getattr__ = passed_on(__name__)
