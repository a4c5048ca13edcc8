"""When a message was made, as filters see it."""

from __future__ import annotations

from typing import Any

from rclpy.clock import ROSClock
from rclpy.logging import get_logger
from rclpy.time import Time

NO_STAMP = (
    'can not use message filters for messages without timestamp infomation when "allow_headerless" is disabled. '
    'auto assign ROSTIME to headerless messages once enabling constructor option of "allow_headerless".'
)


def stamp_of(message: Any, allow_headerless: bool, logger_name: str) -> Time | None:
    """The stamp in the header. Without one it is now, where that is allowed; else None, after a warning in ROS 2's words."""
    stamp = getattr(getattr(message, 'header', None), 'stamp', None)
    if stamp is None:
        if allow_headerless:
            return ROSClock().now()
        get_logger(logger_name).warning(NO_STAMP)
        return None
    return stamp if hasattr(stamp, 'nanoseconds') else Time.from_msg(stamp)
