"""Checks the name and the namespace of a node with rclpy's own errors, and converts them to words of the command line."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from launch.substitutions.local_substitution import LocalSubstitution

from edulaunch.engine.graph.names import namespace_problem, node_name_problem

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

# This quick check accepts most valid names; slower checks find out what is wrong with the others.
_GOOD_NAME = re.compile(r'[A-Za-z_][A-Za-z0-9_]{0,99}')
_GOOD_NAMESPACE = re.compile(r'/|(?:/[A-Za-z_][A-Za-z0-9_]{0,39}){1,5}')


def validated_name(name: str) -> str:
    """Return the name if it is valid.

    :raises InvalidNodeNameException: when it is not a valid node name.
    """
    if _GOOD_NAME.fullmatch(name) is None and node_name_problem(name) is not None:
        from rclpy.validate_node_name import validate_node_name

        validate_node_name(name)
    return name


def validated_namespace(namespace: str) -> str:
    """Return the namespace if it is valid.

    :raises InvalidNamespaceException: when it is not a valid namespace.
    """
    if _GOOD_NAMESPACE.fullmatch(namespace) is None and namespace_problem(namespace) is not None:
        from rclpy.validate_namespace import validate_namespace

        validate_namespace(namespace)
    return namespace


class _SpecificArgument(LocalSubstitution):
    """A word of the command line from the context's local `ros_specific_arguments`, which a node sets when it is executed."""

    def __init__(self, key: str, description: str) -> None:
        super().__init__(f"ros_specific_arguments['{key}']", description=description)
        self._key = key

    def perform(self, context: LaunchContext) -> str:
        """Return the same string as the base class, without compiling an expression."""
        arguments: dict[str, str] = context.local('ros_specific_arguments')
        return arguments[self._key]


NODE_NAME = _SpecificArgument('name', 'node name')


NODE_NAMESPACE = _SpecificArgument('ns', 'node namespace')
