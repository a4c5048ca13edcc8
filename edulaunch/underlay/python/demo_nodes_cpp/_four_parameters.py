"""A node with four parameters of its own, which it sets once."""

from __future__ import annotations

from rclcpp_like import CppNode
from rclpy.parameter import Parameter

DEFAULTS = {'foo': 0, 'bar': '', 'baz': 0.0, 'foobar': False}
VALUES = {'foo': 2, 'bar': 'hello', 'baz': 1.45, 'foobar': True}


def make_node(node_name: str) -> CppNode:
    """The node, with its parameters set. What is refused is logged as an error."""
    node = CppNode(node_name)
    for name, value in DEFAULTS.items():
        node.declare_parameter(name, value)
    for result in node.set_parameters([Parameter(name, value=value) for name, value in VALUES.items()]):
        if not result.successful:
            node.get_logger().error(f'Failed to set parameter: {result.reason}')
    return node
