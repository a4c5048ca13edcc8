"""The rules for topic and service names in programs."""

from __future__ import annotations

from edulaunch.engine.graph.names import topic_name_problem
from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException
from rclpy.impl.refusals import check_is_text


def validate_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True. Raise InvalidTopicNameException or InvalidServiceNameException for an invalid name."""
    check_is_text(name, 'topic_name')
    problem = topic_name_problem(name)
    if problem is None:
        return True
    raise (InvalidServiceNameException if is_service else InvalidTopicNameException)(name, *problem)
