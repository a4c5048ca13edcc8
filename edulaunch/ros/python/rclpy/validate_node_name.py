"""The rules for node names."""

from __future__ import annotations

from edulaunch.engine.graph.names import node_name_problem
from rclpy.exceptions import InvalidNodeNameException
from rclpy.impl.refusals import check_is_text


def validate_node_name(node_name: str) -> bool:
    """Return True. Raise InvalidNodeNameException for an invalid name."""
    check_is_text(node_name, 'node_name')
    problem = node_name_problem(node_name)
    if problem is None:
        return True
    raise InvalidNodeNameException(node_name, *problem)
