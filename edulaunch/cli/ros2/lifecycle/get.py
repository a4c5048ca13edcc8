"""`ros2 lifecycle get`: the state of one lifecycle node, or of all."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, lifecycle_nodes
from edulaunch.cli.ros2.output import say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 lifecycle get`."""
    lifecycle_nodes.add_arguments(parser)
    parser.add_argument('node_name', nargs='?', help='Name of the ROS node')


def main(arguments: argparse.Namespace) -> None:
    """Print label and number of the state; of all nodes with their names before them."""
    if arguments.node_name is not None:
        with lifecycle_nodes.lifecycle_node(arguments) as one:
            say(one.state())
        return
    with cli_node.cli_node(arguments) as node:
        for name in lifecycle_nodes.found(node, arguments.include_hidden_nodes):
            say(f'{name}: {lifecycle_nodes.LifecycleNodeOf(node, name).state()}')
