"""`ros2 service echo`: listen to the calls of a service."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, names, printing, qos_options
from edulaunch.cli.ros2.interface_class import interface_class
from edulaunch.cli.ros2.output import with_help
from edulaunch.errors import InterfaceError
from edulaunch.nearest import did_you_mean

HOW = 'configure_introspection() of the server or the client switches it on'


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The service, its type, and how events are printed."""
    cli_node.add_arguments(parser)
    parser.add_argument('service_name', help="Name of the ROS service to echo (e.g. '/add_two_ints')")
    parser.add_argument('service_type', nargs='?', help="Type of the ROS service (e.g. 'example_interfaces/srv/AddTwoInts')")
    printing.add_arguments(parser)
    parser.add_argument('--once', action='store_true', help='Print the first event received and then exit')
    parser.add_argument('--timeout', metavar='N', type=float, help='Set a timeout in seconds for waiting')
    qos_options.add_arguments(parser, 'services_default')


def main(arguments: argparse.Namespace) -> str | None:
    """Print each event that comes, until interrupted."""
    import rclpy

    with cli_node.cli_node(arguments) as node:
        service = node.resolve_service_name(arguments.service_name)
        services = node.get_service_names_and_types()
        types = [arguments.service_type] if arguments.service_type else names.types_of(service, services)
        if not types:
            known = did_you_mean(service, [name for name, _ in services])
            return with_help(
                f"Could not determine the type for the passed service '{service}'", known or 'see `ros2 service list`'
            )
        try:
            cls = interface_class(types[0], 'srv')
        except InterfaceError as error:
            return with_help('The passed service type is invalid', error.help)
        topic = f'{service}/_service_event'
        if not node.count_publishers(topic):
            return with_help(f"No publishers on topic '{topic}'; is service introspection on the client or server enabled?", HOW)
        done = rclpy.task.Future()
        printer = printing.Printer(arguments, done)
        node.create_subscription(cls.Event, topic, printer.on_message, qos_options.profile(arguments))
        rclpy.spin_until_future_complete(node, done, timeout_sec=arguments.timeout)
    return None
