"""`ros2 service call`: call a service and print its response."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from edulaunch.cli.ros2 import cli_node, names
from edulaunch.cli.ros2.fill_message import FillError, fill_message, parse_values
from edulaunch.cli.ros2.interface_class import interface_class
from edulaunch.cli.ros2.numbers import positive
from edulaunch.cli.ros2.output import complain, say, with_help
from edulaunch.errors import InterfaceError
from edulaunch.nearest import did_you_mean
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.client import Client
    from rclpy.node import Node

PATIENCE_S = 5.0
"""After so long without the service we say what may be wrong; ROS 2 waits for ever in silence."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 service call`."""
    parser.add_argument('service_name', help="Name of the ROS service to call to (e.g. '/add_two_ints')")
    parser.add_argument('service_type', help="Type of the ROS service (e.g. 'std_srvs/srv/Empty')")
    group = parser.add_mutually_exclusive_group()
    group.add_argument('values', nargs='?', default='{}', help='Values to fill the service request with in YAML format')
    group.add_argument('--stdin', action='store_true', help='Read values from standard input')
    parser.add_argument('-r', '--rate', metavar='N', type=positive, help='Repeat the call at a specific rate in Hz')


def main(arguments: argparse.Namespace) -> str | None:
    """Call it once, or again and again at a rate."""
    try:
        cls = interface_class(arguments.service_type, 'srv')
    except InterfaceError as error:
        return with_help('The passed service type is invalid', error.help)
    package, _, name = cls.TYPE.split('/')
    try:
        values = parse_values(current_process().stdin.read() if arguments.stdin else arguments.values)
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
    types = names.types_of(client.service_name, services)
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
