"""`ros2 node list`: which nodes there are."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.output import complain, say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 node list`."""
    cli_node.add_arguments(parser)
    parser.add_argument('-a', '--all', action='store_true', help='Display all nodes even hidden ones')
    parser.add_argument('-c', '--count-nodes', action='store_true', help='Only display the number of nodes discovered')


def main(arguments: argparse.Namespace) -> None:
    """Print their full names, sorted."""
    with cli_node.cli_node(arguments) as node:
        found = names.node_names(node, arguments.all)
    if arguments.count_nodes:
        say(str(len(found)))
        return
    if len(set(found)) < len(found):
        complain(
            'WARNING: Be aware that there are nodes in the graph that share an exact name, '
            'which can have unintended side effects.'
        )
    names.say_lines(found)
