"""`ros2 action info`: who serves and who uses an action."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.action_names import clients_by_node, servers_by_node
from edulaunch.cli.ros2.output import say

if TYPE_CHECKING:
    from rclpy.node import Node


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 action info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('action_name', help="Name of the action to get info (e.g. '/fibonacci')")
    parser.add_argument('-t', '--show-types', action='store_true', help='Additionally show the action type')
    parser.add_argument('-c', '--count', action='store_true', help='Only display the number of action clients and action servers')


def main(arguments: argparse.Namespace) -> None:
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
