"""`ros2 action info|list|type`: which actions there are. (`action_send_goal` has the other.)"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.action_names import action_names_and_types, clients_by_node, servers_by_node
from edulaunch.cli.ros2.output import say

if TYPE_CHECKING:
    from rclpy.node import Node


def info_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 action info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('action_name', help="Name of the action to get info (e.g. '/fibonacci')")
    parser.add_argument('-t', '--show-types', action='store_true', help='Additionally show the action type')
    parser.add_argument('-c', '--count', action='store_true', help='Only display the number of action clients and action servers')


def info_verb(arguments: argparse.Namespace) -> None:
    """Print the nodes on both sides."""
    action = arguments.action_name
    with cli_node.cli_node(arguments) as node:
        sides = (('clients', _nodes(node, action, clients_by_node)), ('servers', _nodes(node, action, servers_by_node)))
    say(f'Action: {action}')
    for side, found in sides:
        say(f'Action {side}: {len(found)}')
        if not arguments.count:
            names.say_lines(
                [f'    {name} [{", ".join(types)}]' if arguments.show_types else f'    {name}' for name, types in found]
            )


def _nodes(node: Node, action: str, actions_by_node: Callable[[Node, str, str], names.NamesAndTypes]) -> names.NamesAndTypes:
    found = []
    for name, namespace in node.get_node_names_and_namespaces():
        types = names.types_of(action, actions_by_node(node, name, namespace))
        if types:
            found.append((f'{namespace.rstrip("/")}/{name}', types))
    return sorted(found)


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 action list`."""
    cli_node.add_arguments(parser)
    names.add_list_arguments(parser, 'action')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        names.say_names(action_names_and_types(node), arguments)


def type_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 action type`."""
    cli_node.add_arguments(parser)
    parser.add_argument('action_name', help="Name of the ROS action to get type (e.g. '/fibonacci')")


def type_verb(arguments: argparse.Namespace) -> int:
    """Print it; status 1 in silence when there is no such action, as in ROS 2."""
    with cli_node.cli_node(arguments) as node:
        types = names.types_of(arguments.action_name, action_names_and_types(node))
    names.say_lines(types)
    return 0 if types else 1
