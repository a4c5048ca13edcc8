"""`ros2 node`: list the nodes, and show the topics, services and actions of one node."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from edulaunch.desk.cli.ros2 import cli_node, graph_names
from edulaunch.desk.cli.ros2.output import complain, say, say_lines, with_help
from edulaunch.engine.nearest import did_you_mean

if TYPE_CHECKING:
    from rclpy.node import Node


def info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 node info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('node_name', help='Fully qualified node name to request information with given spin time')
    parser.add_argument('--include-hidden', action='store_true', help='Display hidden topics, services, and actions as well')


def info_verb(arguments: argparse.Namespace) -> str | None:
    """Print the subscriptions, publishers, services and actions of a node in six lists, each sorted by name."""
    wanted = arguments.node_name
    with cli_node.cli_node(arguments) as node:
        known = graph_names.node_names(node)
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
            shown = [f'    {name}: {", ".join(types)}' for name, types in graph_names.visible(entries, arguments.include_hidden)]
            say('\n'.join(shown))
    return None


def _sections(node: Node, wanted: str) -> list[tuple[str, graph_names.NamesAndTypes]]:
    namespace, _, name = wanted.rpartition('/')
    where = (name, namespace or '/')
    return [
        ('Subscribers', node.get_subscriber_names_and_types_by_node(*where)),
        ('Publishers', node.get_publisher_names_and_types_by_node(*where)),
        ('Service Servers', node.get_service_names_and_types_by_node(*where)),
        ('Service Clients', node.get_client_names_and_types_by_node(*where)),
        ('Action Servers', graph_names.servers_by_node(node, *where)),
        ('Action Clients', graph_names.clients_by_node(node, *where)),
    ]


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 node list`."""
    cli_node.add_arguments(parser)
    parser.add_argument('-a', '--all', action='store_true', help='Display all nodes even hidden ones')
    parser.add_argument('-c', '--count-nodes', action='store_true', help='Only display the number of nodes discovered')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print the full names of the nodes in alphabetical order, or only their number."""
    with cli_node.cli_node(arguments) as node:
        found = graph_names.node_names(node, arguments.all)
    if arguments.count_nodes:
        say(str(len(found)))
        return
    if len(set(found)) < len(found):
        complain(
            'WARNING: Be aware that there are nodes in the graph that share an exact name, '
            'which can have unintended side effects.'
        )
    say_lines(found)
