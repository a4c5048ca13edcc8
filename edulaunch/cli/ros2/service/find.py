"""`ros2 service find`: the services of a type."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service find`."""
    cli_node.add_arguments(parser)
    parser.add_argument(
        'service_type', help="Name of the ROS service type to filter for (e.g. 'rcl_interfaces/srv/ListParameters')"
    )
    parser.add_argument(
        '-c', '--count-services', dest='count', action='store_true', help='Only display the number of services discovered'
    )
    parser.add_argument('--include-hidden-services', action='store_true', help='Consider hidden services as well')


def main(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        services = names.visible(node.get_service_names_and_types(), arguments.include_hidden_services)
    names.say_found(services, arguments.service_type, arguments.count)
