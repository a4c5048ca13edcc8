"""The numbers of log levels are those of ROS 2."""

from __future__ import annotations

from rclpy.impl.logging_severity import LoggingSeverity


def test_levels_have_the_numbers_of_ros() -> None:
    assert [(level.name, level.value) for level in LoggingSeverity] == [
        ('UNSET', 0),
        ('DEBUG', 10),
        ('INFO', 20),
        ('WARN', 30),
        ('ERROR', 40),
        ('FATAL', 50),
    ]
