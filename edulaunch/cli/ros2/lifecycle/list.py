"""`ros2 lifecycle list`: the transitions that a lifecycle node can make."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import lifecycle_nodes
from edulaunch.cli.ros2.output import say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 lifecycle list`."""
    lifecycle_nodes.add_arguments(parser)
    parser.add_argument('node_name', help='Name of the ROS node')
    parser.add_argument('-a', '--all', action='store_true', help='Display all existing transitions')


def main(arguments: argparse.Namespace) -> None:
    """Print each with the state that it starts from and the one that it leads to."""
    with lifecycle_nodes.lifecycle_node(arguments) as node:
        for found in node.transitions(arguments.all):
            say(lifecycle_nodes.described(found.transition))
            say(f'\tStart: {found.start_state.label}')
            say(f'\tGoal: {found.goal_state.label}')
