"""The old name of `rclpy.event_handler`. In ROS 2, importing it prints a warning. Here it prints none, because all processes
share the module.
"""

from __future__ import annotations

from edulaunch.ros.passed_on import passed_on

__getattr__ = passed_on(__name__)
