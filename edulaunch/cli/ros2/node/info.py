"""`ros2 node info`: what a node offers and uses."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.action_names import clients_by_node, servers_by_node
from edulaunch.cli.ros2.output import complain, say, with_help
from edulaunch.nearest import did_you_mean

if TYPE_CHECKING:
    from rclpy.node import Node


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 node info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('node_name', help='Fully qualified node name to request information with given spin time')
    parser.add_argument('--include-hidden', action='store_true', help='Display hidden topics, services, and actions as well')


def main(arguments: argparse.Namespace) -> str | None:
    """Print six lists, each sorted by name."""
    wanted = arguments.node_name
    with cli_node.cli_node(arguments) as node:
        known = names.node_names(node)
        count = known.count(wanted)
        if not count:
            return with_help(f"Unable to find node '{wanted}'", did_you_mean(wanted, known))
        if count > 1:
            complain(
                f'There are {count} nodes in the graph with the exact name "{wanted}". '
                'You are seeing information about only one of them.'
            )
        say(wanted)
        for heading, entries in _sections(node, wanted):
            say(f'  {heading}:')
            shown = [f'    {name}: {", ".join(types)}' for name, types in names.visible(entries, arguments.include_hidden)]
            say('\n'.join(shown))
    return None


def _sections(node: Node, wanted: str) -> list[tuple[str, names.NamesAndTypes]]:
    namespace, _, name = wanted.rpartition('/')
    where = (name, namespace or '/')
    return [
        ('Subscribers', node.get_subscriber_names_and_types_by_node(*where)),
        ('Publishers', node.get_publisher_names_and_types_by_node(*where)),
        ('Service Servers', node.get_service_names_and_types_by_node(*where)),
        ('Service Clients', node.get_client_names_and_types_by_node(*where)),
        ('Action Servers', servers_by_node(node, *where)),
        ('Action Clients', clients_by_node(node, *where)),
    ]
