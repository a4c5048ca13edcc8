"""`ros2 topic type`: the type of a topic."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic type`."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_name', help="Name of the ROS topic to get type (e.g. '/chatter')")


def main(arguments: argparse.Namespace) -> int:
    """Print it; status 1 in silence when there is no such topic, as in ROS 2."""
    with cli_node.cli_node(arguments) as node:
        types = names.types_of(arguments.topic_name, node.get_topic_names_and_types())
    names.say_lines(types)
    return 0 if types else 1
