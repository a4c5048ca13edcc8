"""The rules for expanded topic and service names."""

from __future__ import annotations

from edulaunch.engine.graph.names import full_topic_name_problem
from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException
from rclpy.impl.refusals import check_is_text


def validate_full_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True. Raise InvalidTopicNameException or InvalidServiceNameException for an invalid name."""
    check_is_text(name, 'full_topic_name')
    problem = full_topic_name_problem(name)
    if problem is None:
        return True
    raise (InvalidServiceNameException if is_service else InvalidTopicNameException)(name, *problem)
