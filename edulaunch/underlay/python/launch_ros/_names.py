"""Checks of node names and namespaces, with rclpy's own errors."""

from __future__ import annotations

from edulaunch.graph.names import namespace_problem, node_name_problem


def validated_name(name: str) -> str:
    """The name.

    :raises InvalidNodeNameException: when no node can be called so.
    """
    if node_name_problem(name) is not None:
        from rclpy.validate_node_name import validate_node_name

        validate_node_name(name)
    return name


def validated_namespace(namespace: str) -> str:
    """The namespace.

    :raises InvalidNamespaceException: when it cannot be one.
    """
    if namespace_problem(namespace) is not None:
        from rclpy.validate_namespace import validate_namespace

        validate_namespace(namespace)
    return namespace
