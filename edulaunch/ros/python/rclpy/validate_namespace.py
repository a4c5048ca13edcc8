"""The rules for namespaces."""

from __future__ import annotations

from edulaunch.engine.graph.names import namespace_problem
from rclpy.exceptions import InvalidNamespaceException
from rclpy.impl.refusals import check_is_text


def validate_namespace(namespace: str) -> bool:
    """Return True. Raise InvalidNamespaceException for an invalid absolute namespace."""
    check_is_text(namespace, 'namespace')
    problem = namespace_problem(namespace)
    if problem is None:
        return True
    raise InvalidNamespaceException(namespace, *problem)
