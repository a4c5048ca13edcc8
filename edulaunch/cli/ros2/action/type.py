"""`ros2 action type`: the type of an action."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.action_names import action_names_and_types


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 action type`."""
    cli_node.add_arguments(parser)
    parser.add_argument('action_name', help="Name of the ROS action to get type (e.g. '/fibonacci')")


def main(arguments: argparse.Namespace) -> int:
    """Print it; status 1 in silence when there is no such action, as in ROS 2."""
    with cli_node.cli_node(arguments) as node:
        types = names.types_of(arguments.action_name, action_names_and_types(node))
    names.say_lines(types)
    return 0 if types else 1
