"""The programs list_parameters, set_and_get_parameters and parameter_blackboard."""

from __future__ import annotations

from typing import Any

from rclcpp_like import CppNode, program, spinning
from rclpy.parameter import Parameter

DEFAULTS = {'foo': 0, 'bar': '', 'baz': 0.0, 'foobar': False}
VALUES = {'foo': 2, 'bar': 'hello', 'baz': 1.45, 'foobar': True}
TYPE_NAMES = {int: 'integer', str: 'string', float: 'double', bool: 'bool'}


def make_node(node_name: str) -> CppNode:
    """Return the node with its parameters set. Log an error for each rejected parameter."""
    node = CppNode(node_name)
    for name, value in DEFAULTS.items():
        node.declare_parameter(name, value)
    for result in node.set_parameters([Parameter(name, value=value) for name, value in VALUES.items()]):
        if not result.successful:
            node.get_logger().error(f'Failed to set parameter: {result.reason}')
    return node


def _list() -> None:
    """Log a list of the parameters. The program then ends."""
    node = make_node('list_parameters')
    log = node.get_logger()
    log.info('Listing parameters...')
    found = node.list_parameters([*VALUES], 10)
    names, prefixes = (''.join(f'\n {name}' for name in group) for group in (found.names, found.prefixes))
    log.info(f'\nParameter names:{names}\nParameter prefixes:{prefixes}')


def _set_and_get() -> None:
    """Read the parameters and log them. The program then ends."""
    node = make_node('set_and_get_parameters')
    lines = [_described(name, node.get_parameter(name).value) for name in VALUES]
    node.get_logger().info(''.join(lines))


def _described(name: str, value: Any) -> str:
    text = str(value)
    if isinstance(value, float):
        text = f'{value:f}'
    elif isinstance(value, bool):
        text = text.lower()
    return f'\nParameter name: {name}\nParameter value ({TYPE_NAMES[type(value)]}): {text}'


class ParameterBlackboard(CppNode):
    """Accepts undeclared parameters, and declares the parameters of the command line."""

    def __init__(self, **options: Any) -> None:
        super().__init__(
            'parameter_blackboard',
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
            **options,
        )
        count = len(self.list_parameters([], 0).names)
        self.get_logger().info(
            f"Parameter blackboard node named '{self.get_fully_qualified_name()}' ready, "
            f"and serving '{count}' parameters already!"
        )


list_parameters = program(_list)
set_and_get_parameters = program(_set_and_get)
parameter_blackboard = spinning(ParameterBlackboard)
