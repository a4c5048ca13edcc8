"""`<ros_timer period=>...</ros_timer>`: actions after some ROS time."""

from __future__ import annotations

from launch_ros.actions.ros_timer import ROSTimer

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .timer import timer_attributes


def parse_ros_timer(entity: Entity, parser: Parser) -> Parsed:
    """A timer on ROS time; the period is in seconds."""
    return ROSTimer, timer_attributes(entity, parser)
