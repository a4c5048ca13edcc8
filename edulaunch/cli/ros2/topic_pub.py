"""`ros2 topic pub`: publish messages."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from edulaunch.cli.ros2 import cli_node, qos_options
from edulaunch.cli.ros2.fill_message import FillError, fill_message, parse_values
from edulaunch.cli.ros2.interface_class import interface_class
from edulaunch.cli.ros2.numbers import positive
from edulaunch.cli.ros2.output import say, with_help
from edulaunch.errors import InterfaceError
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.publisher import Publisher


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic pub`."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_name', help="Name of the ROS topic to publish to (e.g. '/chatter')")
    parser.add_argument('message_type', help="Type of the ROS message (e.g. 'std_msgs/String')")
    group = parser.add_mutually_exclusive_group()
    group.add_argument('values', nargs='?', default='{}', help='Values to fill the message with in YAML format')
    group.add_argument('--stdin', action='store_true', help='Read values from standard input')
    parser.add_argument('-r', '--rate', metavar='N', type=positive, default=1.0, help='Publishing rate in Hz (default: 1)')
    parser.add_argument(
        '-p', '--print', metavar='N', type=int, default=1, help='Only print every N-th published message (default: 1)'
    )
    _add_times(parser)


def _add_times(parser: argparse.ArgumentParser) -> None:
    """How often, and for whom."""
    times = parser.add_mutually_exclusive_group()
    times.add_argument('-1', '--once', action='store_true', help='Publish one message and exit')
    times.add_argument('-t', '--times', type=int, default=0, help='Publish this number of times and then exit')
    parser.add_argument(
        '-w',
        '--wait-matching-subscriptions',
        type=int,
        default=None,
        help='Wait until finding the specified number of matching subscriptions (default: 1 when using -1 or -t, else 0)',
    )
    parser.add_argument('--max-wait-time-secs', type=positive, default=None, help='Longest wait for matching subscriptions')
    parser.add_argument(
        '--keep-alive', metavar='N', type=float, default=0.1, help='Keep publishing node alive for N seconds after the last msg'
    )
    parser.add_argument('-n', '--node-name', help='Name of the created publishing node')
    qos_options.add_arguments(parser, 'default')


def main(arguments: argparse.Namespace) -> str | None:
    """Publish the message once, some times, or until interrupted."""
    try:
        cls = interface_class(arguments.message_type, 'msg')
    except InterfaceError as error:
        return with_help('The passed message type is invalid', error.help)
    with cli_node.cli_node(arguments, arguments.node_name) as node:
        message = cls()
        try:
            values = parse_values(current_process().stdin.read() if arguments.stdin else arguments.values)
            stamps = fill_message(message, values, stamps=True)
        except FillError as error:
            return str(error)
        publisher = node.create_publisher(cls, arguments.topic_name, qos_options.profile(arguments))
        times = 1 if arguments.once else arguments.times
        problem = _wait_for_subscriptions(node, publisher, arguments, default=1 if times else 0)
        if problem is None:
            _publish(node, publisher, message, stamps, arguments, times)
    return problem


def _wait_for_subscriptions(node: Node, publisher: Publisher, arguments: argparse.Namespace, default: int) -> str | None:
    """Look each 0.1 s, and say each second that we wait."""
    wanted = default if arguments.wait_matching_subscriptions is None else arguments.wait_matching_subscriptions
    looks = 0
    while publisher.get_subscription_count() < wanted:
        if looks % 10 == 0:
            say(f'Waiting for at least {wanted} matching subscription(s)...')
        if arguments.max_wait_time_secs is not None and looks / 10 >= arguments.max_wait_time_secs:
            return (
                f'Timed out waiting for subscribers: Expected {wanted} subcribers but only got '
                f'{publisher.get_subscription_count()} subscribers'
            )
        looks += 1
        if not cli_node.pause(node, 0.1):
            break
    return None


def _publish(
    node: Node, publisher: Publisher, message: Any, stamps: list[Any], arguments: argparse.Namespace, times: int
) -> None:
    say('publisher: beginning loop')
    period_ns, count = round(1e9 / arguments.rate), 0
    start_ns = current_process().sim.now_ns
    while node.context.ok():
        count += 1
        for stamp in stamps:
            stamp(node.get_clock().now().to_msg())
        if arguments.print and count % arguments.print == 0:
            say(f'publishing #{count}: {message!r}\n')
        publisher.publish(message)
        if count == times:
            cli_node.pause(node, arguments.keep_alive)
            return
        cli_node.pause_until(node, start_ns + count * period_ns)
