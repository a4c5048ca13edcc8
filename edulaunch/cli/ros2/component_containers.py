"""The containers of components in the graph, and asking them."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.output import with_help
from edulaunch.nearest import did_you_mean

if TYPE_CHECKING:
    from rclpy.node import Node

_LIST = '/_container/list_nodes'
RESOURCE_TYPE = 'rclcpp_components'


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The container."""
    cli_node.add_arguments(parser)
    parser.add_argument('container_node_name', help='Container node name')


def add_load_arguments(parser: argparse.ArgumentParser) -> None:
    """Which component, and as what node."""
    parser.add_argument('package_name', help='Package name where the component can be found')
    parser.add_argument('plugin_name', help='Type name of the component, such as composition::Talker')
    parser.add_argument('-n', '--node-name', help='Component node name')
    parser.add_argument('--node-namespace', help='Component node namespace')
    parser.add_argument('--log-level', help='Component node log level')
    parser.add_argument('-r', '--remap', dest='remap_rules', action='append', default=[], help="Remapping rule 'from:=to'")
    parser.add_argument('-p', '--parameter', dest='parameters', action='append', default=[], help="Parameter 'name:=value'")
    parser.add_argument(
        '-e', '--extra-argument', dest='extra_arguments', action='append', default=[], help="Extra argument 'name:=value'"
    )


def found(node: Node) -> list[str]:
    """The full names of all containers, sorted."""
    return sorted(name.removesuffix(_LIST) for name, _ in node.get_service_names_and_types() if name.endswith(_LIST))


def container(node: Node, name: str) -> str:
    """The full name of the container that the command line names.

    :raises RuntimeError: when there is none of that name; in the words of ROS 2.
    """
    name, known = names.absolute(name), found(node)
    if name not in known:
        raise RuntimeError(
            with_help(f"Unable to find container node '{name}'", did_you_mean(name, known) or 'see `ros2 component list`')
        )
    return name


def components(node: Node, name: str) -> list[tuple[int, str]]:
    """Number and full name of each node in a container."""
    from composition_interfaces.srv import ListNodes

    answer = cli_node.call(node, name + _LIST, ListNodes)
    return list(zip(answer.unique_ids, answer.full_node_names, strict=True))


def load(node: Node, name: str, arguments: argparse.Namespace) -> str | None:
    """Load a component into a container and say so; returns the text of an error."""
    from composition_interfaces.srv import LoadNode

    from edulaunch.cli.ros2.output import say

    answer = cli_node.call(
        node,
        f'{name}/_container/load_node',
        LoadNode,
        package_name=arguments.package_name,
        plugin_name=arguments.plugin_name,
        node_name=arguments.node_name or '',
        node_namespace=arguments.node_namespace or '',
        log_level=_level(arguments.log_level),
        remap_rules=arguments.remap_rules,
        parameters=list(map(_parameter, arguments.parameters)),
        extra_arguments=list(map(_parameter, arguments.extra_arguments)),
    )
    if not answer.success:
        return f'Failed to load component: {answer.error_message}'.rstrip(': ').capitalize()
    say(f"Loaded component {answer.unique_id} into '{name}' container node as '{answer.full_node_name}'")
    return None


def _level(word: str | None) -> int:
    """A severity by name, as the service wants it; 0 when none is given.

    :raises RuntimeError: for a word that is none.
    """
    from rclpy.logging import get_logging_severity_from_string

    try:
        return 0 if word is None else int(get_logging_severity_from_string(word))
    except RuntimeError:
        raise RuntimeError(with_help(f"'{word}' is no log level", 'one of: debug, info, warn, error, fatal')) from None


def _parameter(text: str) -> Any:
    from rcl_interfaces.msg import Parameter
    from rclpy.parameter import get_parameter_value

    name, sign, value = text.partition(':=')
    if not sign:
        raise RuntimeError(with_help(f"'{text}' is no parameter", 'write it as name:=value'))
    return Parameter(name=name, value=get_parameter_value(value))
