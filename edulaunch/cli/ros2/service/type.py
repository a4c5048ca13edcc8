"""`ros2 service type`: the type of a service."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service type`."""
    cli_node.add_arguments(parser)
    parser.add_argument('service_name', help="Name of the ROS service to get type (e.g. '/talker/list_parameters')")


def main(arguments: argparse.Namespace) -> int:
    """Print it; status 1 in silence when there is no such service, as in ROS 2."""
    with cli_node.cli_node(arguments) as node:
        types = names.types_of(arguments.service_name, node.get_service_names_and_types())
    names.say_lines(types)
    return 0 if types else 1
