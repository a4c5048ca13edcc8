"""`ros2 lifecycle set`: let a lifecycle node make a transition."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import lifecycle_nodes
from edulaunch.cli.ros2.output import complain, say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 lifecycle set`."""
    lifecycle_nodes.add_arguments(parser)
    parser.add_argument('node_name', help='Name of the ROS node')
    parser.add_argument('transition', help='The lifecycle transition')


def main(arguments: argparse.Namespace) -> str | None:
    """Print how it went; status 0 either way, as in ROS 2. One that the node cannot make now is an error."""
    with lifecycle_nodes.lifecycle_node(arguments) as node:
        possible = [found.transition for found in node.transitions()]
        number = next((one.id for one in possible if arguments.transition in (one.label, str(one.id))), None)
        if number is None:
            return '\n'.join(['Unknown transition requested, available ones are:', *map(lifecycle_nodes.described, possible)])
        successful = node.change(number)
    if successful:
        say('Transitioning successful')
    else:
        complain('Transitioning failed')
    return None
