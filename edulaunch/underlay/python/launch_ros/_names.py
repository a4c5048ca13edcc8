"""Checks of node names and namespaces, with rclpy's own errors."""

from __future__ import annotations

import re

from edulaunch.graph.names import namespace_problem, node_name_problem

# Most names are right, which one look tells; the slower checks know what is wrong.
_GOOD_NAME = re.compile(r'[A-Za-z_][A-Za-z0-9_]{0,99}')
_GOOD_NAMESPACE = re.compile(r'/|(?:/[A-Za-z_][A-Za-z0-9_]{0,39}){1,5}')


def validated_name(name: str) -> str:
    """The name.

    :raises InvalidNodeNameException: when no node can be called so.
    """
    if _GOOD_NAME.fullmatch(name) is None and node_name_problem(name) is not None:
        from rclpy.validate_node_name import validate_node_name

        validate_node_name(name)
    return name


def validated_namespace(namespace: str) -> str:
    """The namespace.

    :raises InvalidNamespaceException: when it cannot be one.
    """
    if _GOOD_NAMESPACE.fullmatch(namespace) is None and namespace_problem(namespace) is not None:
        from rclpy.validate_namespace import validate_namespace

        validate_namespace(namespace)
    return namespace
