"""The kinds of clocks."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

from rclpy.impl.c_enum import CEnum


class ClockType(IntEnum):
    """The kind of time that a clock shows. In a simulation, all three kinds are simulated time; ROS time can also follow
    /clock.
    """

    UNINITIALIZED = 0
    ROS_TIME = 1
    SYSTEM_TIME = 2
    STEADY_TIME = 3


TypeOfTime: Any = CEnum('ClockType', [(kind.name, kind.value) for kind in ClockType])  # type: ignore[call-arg, arg-type]
"""The type of `Time.clock_type`. It equals a :class:`ClockType`, but is a different object and prints as `ClockType.ROS_TIME`."""
