"""The node that a command creates, and functions that wait in simulated time."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2.output import complain
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.task import current_task

if TYPE_CHECKING:
    from rclpy.node import Node

DISCOVERY_S = 0.5
"""A command of ROS 2 waits this many seconds before it relies on its knowledge of the graph."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options for discovery, which most verbs have."""
    parser.add_argument(
        '--spin-time',
        type=float,
        default=None,
        metavar='SPIN_TIME',
        help='Spin time in seconds to wait for discovery (default: until the simulation is 0.5 s old)',
    )
    parser.add_argument('-s', '--use-sim-time', action='store_true', help='Enable ROS simulation time')
    parser.add_argument('--no-daemon', action='store_true', help='Do not use a running daemon; wait for discovery')


@contextmanager
def cli_node(arguments: argparse.Namespace | None = None, name: str | None = None, *, signals: str = 'ALL') -> Iterator[Node]:
    """Start ROS 2 with one node, for a `with` statement. Shut ROS 2 down at the end.

    :param arguments: the parsed options. If they are given, first wait until the graph is known; otherwise, start immediately.
    :param name: the name of the node (default: `_ros2cli_<pid>`).
    :param signals: the name of the `SignalHandlerOptions` for the signals that shut ROS 2 down. A command that still has work
        after Ctrl-C leaves out SIGINT.
    """
    import rclpy
    from rclpy.parameter import Parameter
    from rclpy.signals import SignalHandlerOptions

    rclpy.init(args=[], signal_handler_options=getattr(SignalHandlerOptions, signals))
    sim_time = [Parameter('use_sim_time', value=True)] if getattr(arguments, 'use_sim_time', False) else []
    node = rclpy.create_node(
        name or f'_ros2cli_{current_process().pid}', start_parameter_services=False, parameter_overrides=sim_time
    )
    try:
        if arguments is not None:
            discover(node, arguments)
        yield node
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


def discover(node: Node, arguments: argparse.Namespace) -> None:
    """Wait until the graph is known.

    In ROS 2, the first command waits for half a second and starts a daemon, which answers later commands immediately. Here the
    graph is known when the simulation is half a second old. So a command in a launch file sees the processes that started at the
    same time.
    """
    host: Any = current_process().host
    if arguments.spin_time is not None:
        pause(node, arguments.spin_time)
    elif arguments.no_daemon:
        pause(node, DISCOVERY_S)
    elif host.is_real:
        host.discover(node)
    else:
        sim = current_task().sim
        pause(node, DISCOVERY_S - (sim.now_ns - sim.start_ns) / 1e9)


def pause(node: Node, seconds: float) -> bool:
    """Wait for a simulated time in seconds. Return False if ROS 2 was shut down in the meantime.

    :raises KeyboardInterrupt: on Ctrl-C.
    """
    return pause_until(node, current_task().sim.now_ns + round(seconds * 1e9))


def pause_until(node: Node, at_ns: int) -> bool:
    """Wait until the simulated time is `at_ns` nanoseconds. The result and the exceptions are the same as for :func:`pause`."""
    sim = current_task().sim
    while sim.now_ns < at_ns and node.context.ok():
        node.context.rcl_park(at_ns)
    return bool(node.context.ok())


class NoAnswer(RuntimeError):
    """A service does not exist, or its node has not replied in time."""


def call(node: Node, service: str, service_type: Any, *, waits_s: Sequence[float | None] = (None,), **fields: Any) -> Any:
    """Call a service and return its response.

    :param service: the name of the service.
    :param service_type: the class of the service.
    :param waits_s: the duration of each waiting period in seconds; None means forever. Before each period except the first, print
        a note that the service has not replied.
    :param fields: the values for the fields of the request.
    :raises NoAnswer: when the last period is over.
    :raises RuntimeError: when there is no response because ROS 2 was shut down.
    """
    import rclpy

    client = node.create_client(service_type, service)
    future = client.call_async(service_type.Request(**fields)) if client.service_is_ready() else None
    waited_s = 0.0
    for wait_s in waits_s:
        if waited_s:
            complain(f'note: {no_answer(service, waited_s)}; waiting for {wait_s:g} s more')
        if future is None and client.wait_for_service(wait_s):
            future = client.call_async(service_type.Request(**fields))
        if future is not None:
            rclpy.spin_until_future_complete(node, future, timeout_sec=wait_s)
            if future.done() or not node.context.ok():
                break
        waited_s += wait_s or 0.0
    else:
        node.destroy_client(client)
        raise NoAnswer(no_answer(service, waited_s))
    node.destroy_client(client)
    response = future.result()
    if response is None:
        raise RuntimeError(f'Exception while calling service of node: {future.exception()!r}')
    return response


def no_answer(service: str, seconds: float) -> str:
    """Return a message that explains why a node has not replied for a time in seconds."""
    name = service.rpartition('/')[0]
    return (
        f'{name} has not answered for {seconds:g} s: it may not spin, a callback may take long, or it may not have this service'
    )
