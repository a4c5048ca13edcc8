"""`ros2 action list`: which actions there are."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.action_names import action_names_and_types


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 action list`."""
    cli_node.add_arguments(parser)
    names.add_list_arguments(parser, 'action')


def main(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        names.say_names(action_names_and_types(node), arguments)
