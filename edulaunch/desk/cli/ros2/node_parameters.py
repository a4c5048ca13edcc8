"""Read and change the parameters of another node through its services."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names
from edulaunch.desk.cli.ros2.output import with_help
from edulaunch.engine.nearest import did_you_mean

if TYPE_CHECKING:
    from rclpy.node import Node

TYPE_WORDS = (
    'not set',
    'boolean',
    'integer',
    'double',
    'string',
    'byte array',
    'boolean array',
    'integer array',
    'double array',
    'string array',
)
LOOK_EVERY_S = 0.1
SPELLINGS = {
    'double': 'write the number with a point, as in 5.0',
    'integer': 'write the number without a point',
    'string': "write '!!str VALUE', in quotation marks",
    'bool': 'write true or false',
}


class NodeNotFound(RuntimeError):
    """No node with the given name appeared in time."""


def add_node_arguments(parser: argparse.ArgumentParser, *, optional: bool = False) -> None:
    """Add the argument for the node, and the option for the time to wait for the node.

    :param parser: the parser to extend.
    :param optional: whether the user may leave out the name.
    """
    cli_node.add_arguments(parser)
    parser.add_argument('node_name', nargs='?' if optional else None, help='Name of the ROS node')
    parser.add_argument('--include-hidden-nodes', action='store_true', help='Consider hidden nodes as well')
    parser.add_argument(
        '--timeout', metavar='N', type=float, default=1.0, help='Wait for N seconds until node becomes available (default: 1)'
    )


class OtherNode:
    """Calls the services of the node `name` from the node of a command.

    :cvar PACKAGE: the package with the types of these services.
    :cvar WAITS_S: the waiting periods in seconds for each call, as in :func:`cli_node.call`.
    """

    PACKAGE: str
    WAITS_S: Sequence[float | None] = (None,)

    def __init__(self, node: Node, name: str) -> None:
        self._node = node
        self.name = name
        self.waits_s = self.WAITS_S

    def _call(self, service: str, cls: str, **fields: Any) -> Any:
        types = import_module(f'{self.PACKAGE}.srv')
        return cli_node.call(self._node, f'{self.name}/{service}', getattr(types, cls), waits_s=self.waits_s, **fields)


class ParametersOf(OtherNode):
    """Reads and changes the parameters of the node `name` with the node's parameter services."""

    PACKAGE = 'rcl_interfaces'
    WAITS_S = (1.0, 9.0)

    def names(self, prefixes: list[str] | None = None) -> list[str]:
        """Return the names of all parameters, sorted. If prefixes are given, return only the names with one of these prefixes."""
        response = self._call('list_parameters', 'ListParameters', prefixes=prefixes or [])
        return sorted(response.result.names)

    def values(self, parameters: list[str]) -> list[Any]:
        """Return the ParameterValues for some names. Return an empty list if one of these parameters is not declared."""
        return list(self._call('get_parameters', 'GetParameters', names=parameters).values)

    def all_values(self) -> dict[str, Any]:
        """Return all parameters that have a value, as plain Python data, sorted by name."""
        known = self.names()
        values = self.values(known)
        if len(values) < len(known):  # one parameter without a value makes the whole response empty
            given = [(name, self.values([name])) for name in known]
            return {name: python_value(found[0]) for name, found in given if found}
        return {name: python_value(value) for name, value in zip(known, values, strict=True)}

    def descriptors(self, parameters: list[str]) -> list[Any]:
        """Return the descriptors for some names. Return an empty list if one of these parameters is not declared."""
        return list(self._call('describe_parameters', 'DescribeParameters', names=parameters).descriptors)

    def set(self, messages: list[Any]) -> list[Any]:
        """Set each parameter separately. Return one result for each parameter."""
        return list(self._call('set_parameters', 'SetParameters', parameters=messages).results)

    def help_for(self, parameter: str) -> str | None:
        """Return a line of help for an unknown parameter that suggests the most similar name, or None if no name is similar."""
        return did_you_mean(parameter, self.names())


@contextmanager
def parameters_of(arguments: argparse.Namespace) -> Iterator[ParametersOf]:
    """Wait for the node that the command line names, and provide its parameters for a `with` statement.

    :raises NodeNotFound: when the node does not appear in time, with the message of ROS 2.
    """
    name = graph_names.absolute(arguments.node_name)
    with cli_node.cli_node(arguments) as node:
        for _ in range(max(1, round(arguments.timeout / LOOK_EVERY_S))):
            if name in graph_names.node_names(node, arguments.include_hidden_nodes):
                yield ParametersOf(node, name)
                return
            cli_node.pause(node, LOOK_EVERY_S)
        known = graph_names.node_names(node, arguments.include_hidden_nodes)
        names_here = (
            f'there is no node {name}; the nodes are: {", ".join(known[:12])}'
            if known
            else f'no node is running, so start {name} first'
        )
        raise NodeNotFound(with_help('Node not found', did_you_mean(name, known) or names_here))


def python_value(value: Any) -> Any:
    """Return a ParameterValue as plain Python data. Arrays become lists, and bytes become numbers."""
    from rclpy.parameter import parameter_value_to_python

    found = parameter_value_to_python(value)
    if hasattr(found, 'tolist'):
        return found.tolist()
    return [item[0] if isinstance(item, bytes) else item for item in found] if isinstance(found, (list, tuple)) else found


def type_help(reason: str) -> str | None:
    """Return a line of help for a value of the wrong type, or None if the reason for the rejection is not a type.

    In YAML, the spelling of a value determines its type, so the help shows the right spelling.
    """
    found = re.search(r"is of type \{(\w+)\}|expected '(?:Parameter\.)?Type\.(\w+)'", reason)
    return None if found is None else SPELLINGS.get((found[1] or found[2]).lower())


def nested_text(values: dict[str, Any], node_name: str) -> str:
    """Return the content of a parameter file with these values. Parameter names with dots become nested keys."""
    import yaml

    tree: dict[str, Any] = {}
    for name, value in values.items():
        *path, last = name.split('.')
        place = tree
        for part in path:
            place = place.setdefault(part, {})
        place[last] = value
    content = {node_name: {'ros__parameters': tree}}
    return yaml.safe_dump(content, default_flow_style=False, width=float('inf'), allow_unicode=True)
