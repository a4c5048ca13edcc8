"""`ros2 service info`: who serves and who asks."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.output import say, with_help
from edulaunch.nearest import did_you_mean


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('service_name', help="Name of the ROS service to get info (e.g. '/add_two_ints')")


def main(arguments: argparse.Namespace) -> str | None:
    """Print type and counts."""
    service = arguments.service_name
    with cli_node.cli_node(arguments) as node:
        services = node.get_service_names_and_types()
        types = names.types_of(service, services)
        if not types:
            return with_help(f"Unknown service '{service}'", did_you_mean(service, [name for name, _ in services]))
        say(f'Type: {types[0] if len(types) == 1 else types}')
        say(f'Clients count: {node.count_clients(service)}')
        say(f'Services count: {node.count_services(service)}')
    return None
