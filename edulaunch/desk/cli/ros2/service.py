"""`ros2 service`: list and describe services, call a service, and print its events."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names, listening
from edulaunch.desk.cli.ros2.fill_message import FillError, fill_message, interface_class, parse_values
from edulaunch.desk.cli.ros2.output import complain, positive_float, say, with_help
from edulaunch.engine.nearest import did_you_mean
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import InterfaceError

if TYPE_CHECKING:
    from rclpy.client import Client
    from rclpy.node import Node

PATIENCE_S = 5.0
"""After this many seconds without the service, suggest what may be wrong; ROS 2 waits forever without a message."""
HOW = 'configure_introspection() of the server or the client switches it on'


def find_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 service find`."""
    graph_names.add_find_arguments(parser, 'service', 'rcl_interfaces/srv/ListParameters')


def find_verb(arguments: argparse.Namespace) -> None:
    """Print the services that have a type, or only their number."""
    with cli_node.cli_node(arguments) as node:
        services = graph_names.visible(node.get_service_names_and_types(), arguments.include_hidden_services)
    graph_names.say_found(services, arguments.service_type, arguments.count)


def info_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 service info`."""
    graph_names.add_name_arguments(parser, 'service', 'get info', '/add_two_ints')


def info_verb(arguments: argparse.Namespace) -> str | None:
    """Print the type of the service, and the numbers of its clients and servers."""
    service = arguments.service_name
    with cli_node.cli_node(arguments) as node:
        services = node.get_service_names_and_types()
        types = graph_names.types_of(service, services)
        if not types:
            return with_help(f"Unknown service '{service}'", did_you_mean(service, [name for name, _ in services]))
        say(f'Type: {types[0] if len(types) == 1 else types}')
        say(f'Clients count: {node.count_clients(service)}')
        say(f'Services count: {node.count_services(service)}')
    return None


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 service list`."""
    graph_names.add_list_arguments(parser, 'service')
    graph_names.add_hidden(parser, 'service')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print the names of the services."""
    with cli_node.cli_node(arguments) as node:
        own = f'{node.get_fully_qualified_name()}/'
        services = [entry for entry in node.get_service_names_and_types() if not entry[0].startswith(own)]
    graph_names.say_names(graph_names.visible(services, arguments.include_hidden_services), arguments)


def type_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 service type`."""
    graph_names.add_name_arguments(parser, 'service', 'get type', '/talker/list_parameters')


def type_verb(arguments: argparse.Namespace) -> int:
    """Print the type of the service. As in ROS 2, return 1 without a message if there is no such service."""
    with cli_node.cli_node(arguments) as node:
        return graph_names.say_types(arguments.service_name, node.get_service_names_and_types())


def call_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 service call`."""
    parser.add_argument('service_name', help="Name of the ROS service to call to (e.g. '/add_two_ints')")
    parser.add_argument('service_type', help="Type of the ROS service (e.g. 'std_srvs/srv/Empty')")
    group = parser.add_mutually_exclusive_group()
    group.add_argument('values', nargs='?', default='{}', help='Values to fill the service request with in YAML format')
    group.add_argument('--stdin', action='store_true', help='Read values from standard input')
    parser.add_argument('-r', '--rate', metavar='N', type=positive_float, help='Repeat the call at a specific rate in Hz')


def call_verb(arguments: argparse.Namespace) -> str | None:
    """Call the service once. With `--rate`, call it repeatedly."""
    try:
        cls = interface_class(arguments.service_type, 'srv')
    except InterfaceError as error:
        return with_help('The passed service type is invalid', error.help)
    package, _, name = cls.TYPE.split('/')
    try:
        values = parse_values(current_process().streams.stdin.read() if arguments.stdin else arguments.values)
        request = cls.Request()
        fill_message(request, values)
    except FillError as error:
        return str(error)
    with cli_node.cli_node(name=f'_ros2cli_requester_{package}_{name}') as node:
        client = node.create_client(cls, arguments.service_name)
        if not client.service_is_ready():
            say('waiting for service to become available...')
            _wait(node, client)
        _request(node, client, request, arguments.rate)
    return None


def _wait(node: Node, client: Client) -> None:
    if client.wait_for_service(timeout_sec=PATIENCE_S) or not node.context.ok():
        return
    services = node.get_service_names_and_types()
    types = graph_names.types_of(client.service_name, services)
    other = (
        f'{client.service_name} has the type {types[0]}'
        if types
        else did_you_mean(client.service_name, [name for name, _ in services])
    )
    complain(
        with_help(f'still waiting for {client.service_name} [{client.srv_type.TYPE}]', other or 'see `ros2 service list -t`')
    )
    client.wait_for_service()


def _request(node: Node, client: Client, request: Any, rate: float | None) -> None:
    import rclpy

    sim = current_process().sim
    while node.context.ok():
        say(f'requester: making request: {request!r}\n')
        sent_ns = sim.now_ns
        future = client.call_async(request)
        rclpy.spin_until_future_complete(node, future)
        if future.result() is None:
            raise RuntimeError(f'Exception while calling service: {future.exception()!r}')
        say(f'response:\n{future.result()!r}\n')
        if rate is None:
            return
        cli_node.pause_until(node, sent_ns + round(1e9 / rate))


def echo_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments for the service and its type, and the options for the output."""
    graph_names.add_name_arguments(parser, 'service', 'echo', '/add_two_ints')
    parser.add_argument('service_type', nargs='?', help="Type of the ROS service (e.g. 'example_interfaces/srv/AddTwoInts')")
    listening.add_printing_arguments(parser)
    parser.add_argument('--once', action='store_true', help='Print the first event received and then exit')
    parser.add_argument('--timeout', metavar='N', type=float, help='Set a timeout in seconds for waiting')
    listening.add_qos_arguments(parser, 'services_default')


def echo_verb(arguments: argparse.Namespace) -> str | None:
    """Print each event of the service until Ctrl-C is pressed or `--timeout` expires. With `--once`, print one event."""
    import rclpy

    with cli_node.cli_node(arguments) as node:
        service = node.resolve_service_name(arguments.service_name)
        services = node.get_service_names_and_types()
        types = [arguments.service_type] if arguments.service_type else graph_names.types_of(service, services)
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
        printer = listening.Printer(arguments, done)
        node.create_subscription(cls.Event, topic, printer.on_message, listening.qos_profile(arguments))
        rclpy.spin_until_future_complete(node, done, timeout_sec=arguments.timeout)
    return None
