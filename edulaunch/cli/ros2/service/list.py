"""`ros2 service list`: which services there are."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service list`."""
    cli_node.add_arguments(parser)
    names.add_list_arguments(parser, 'service')
    parser.add_argument('--include-hidden-services', action='store_true', help='Consider hidden services as well')


def main(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        services = _of_others(node.get_service_names_and_types(), node.get_fully_qualified_name())
    names.say_names(names.visible(services, arguments.include_hidden_services), arguments)


def _of_others(services: names.NamesAndTypes, own_node: str) -> names.NamesAndTypes:
    return [entry for entry in services if not entry[0].startswith(f'{own_node}/')]
