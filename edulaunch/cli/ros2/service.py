"""`ros2 service find|info|list|type`: which services there are. (`service_call` and `service_echo` have the others.)"""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.output import say, with_help
from edulaunch.nearest import did_you_mean


def find_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service find`."""
    cli_node.add_arguments(parser)
    parser.add_argument(
        'service_type', help="Name of the ROS service type to filter for (e.g. 'rcl_interfaces/srv/ListParameters')"
    )
    parser.add_argument(
        '-c', '--count-services', dest='count', action='store_true', help='Only display the number of services discovered'
    )
    parser.add_argument('--include-hidden-services', action='store_true', help='Consider hidden services as well')


def find_verb(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        services = names.visible(node.get_service_names_and_types(), arguments.include_hidden_services)
    names.say_found(services, arguments.service_type, arguments.count)


def info_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service info`."""
    cli_node.add_arguments(parser)
    parser.add_argument('service_name', help="Name of the ROS service to get info (e.g. '/add_two_ints')")


def info_verb(arguments: argparse.Namespace) -> str | None:
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


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service list`."""
    cli_node.add_arguments(parser)
    names.add_list_arguments(parser, 'service')
    parser.add_argument('--include-hidden-services', action='store_true', help='Consider hidden services as well')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    with cli_node.cli_node(arguments) as node:
        services = _of_others(node.get_service_names_and_types(), node.get_fully_qualified_name())
    names.say_names(names.visible(services, arguments.include_hidden_services), arguments)


def _of_others(services: names.NamesAndTypes, own_node: str) -> names.NamesAndTypes:
    return [entry for entry in services if not entry[0].startswith(f'{own_node}/')]


def type_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service type`."""
    cli_node.add_arguments(parser)
    parser.add_argument('service_name', help="Name of the ROS service to get type (e.g. '/talker/list_parameters')")


def type_verb(arguments: argparse.Namespace) -> int:
    """Print it; status 1 in silence when there is no such service, as in ROS 2."""
    with cli_node.cli_node(arguments) as node:
        types = names.types_of(arguments.service_name, node.get_service_names_and_types())
    names.say_lines(types)
    return 0 if types else 1
