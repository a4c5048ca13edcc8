"""The old name of `rclpy.event_handler`. In ROS 2, importing this module prints a warning. Here, the import prints no warning,
because all processes share the module.
"""

from __future__ import annotations

from edulaunch.ros.passed_on import passed_on

__getattr__ = passed_on(__name__)
