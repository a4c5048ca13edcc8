"""`ros2 topic echo`: print messages."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from edulaunch.cli.ros2 import cli_node, qos_options
from edulaunch.cli.ros2.message_filter import message_filter
from edulaunch.cli.ros2.output import complain, say
from edulaunch.cli.ros2.topic_class import topic_class
from edulaunch.interfaces.message import Message
from edulaunch.interfaces.message_text import Shortening, message_csv, message_yaml, plain_value

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.qos import QoSProfile

LONGEST = 128


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """As in ROS 2."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_name', help="Name of the ROS topic to listen to (e.g. '/chatter')")
    parser.add_argument('message_type', nargs='?', help="Type of the ROS message (e.g. 'std_msgs/msg/String')")
    parser.add_argument('--csv', action='store_true', help='Output all recursive fields separated by commas')
    parser.add_argument('--field', metavar='FIELD', help='Echo a selected field of a message')
    parser.add_argument('-f', '--full-length', action='store_true', help='Output all elements for arrays, bytes, and string')
    parser.add_argument(
        '-l',
        '--truncate-length',
        type=int,
        default=LONGEST,
        help=f'The length to truncate arrays, bytes, and string to (default: {LONGEST})',
    )
    parser.add_argument('--no-arr', action='store_true', help="Don't print array fields of messages")
    parser.add_argument('--no-str', action='store_true', help="Don't print string fields of messages")
    parser.add_argument('--flow-style', action='store_true', help='Print collections in the block style')
    parser.add_argument('--no-lost-messages', action='store_true', help="Don't report when a message is lost")
    parser.add_argument('--raw', action='store_true', help='Echo the raw binary representation')
    parser.add_argument('--filter', metavar='EXPR', help="Python expression to select messages, as in 'm.x > 1'")
    parser.add_argument('--once', action='store_true', help='Print the first message received and then exit')
    parser.add_argument('--timeout', metavar='N', type=float, help='Set a timeout in seconds for waiting')
    parser.add_argument('--include-hidden-topics', action='store_true', help='Consider hidden topics as well')
    qos_options.add_arguments(parser, 'sensor_data')


def main(arguments: argparse.Namespace) -> str | int | None:
    """Print each message that comes, until interrupted."""
    import rclpy

    with cli_node.cli_node(arguments) as node:
        cls = topic_class(node, arguments.topic_name, arguments.message_type, verb='echo')
        if isinstance(cls, str):
            return cls
        topic = node.resolve_topic_name(arguments.topic_name)
        done = rclpy.task.Future()
        printer = Printer(arguments, done)
        node.create_subscription(cls, topic, printer.on_message, _suitable_profile(node, topic, arguments), raw=arguments.raw)
        rclpy.spin_until_future_complete(node, done, timeout_sec=arguments.timeout)
    return None


class Printer:
    """Prints what the options ask for; `done` is set after the first when only one is wanted."""

    def __init__(self, arguments: argparse.Namespace, done: Any) -> None:
        self._arguments = arguments
        self._done = done
        self._fields = [name for name in (arguments.field or '').split('.') if name]
        self._passes = message_filter(arguments.filter)
        length = None if arguments.full_length else arguments.truncate_length
        self._short = Shortening(length, arguments.no_arr, arguments.no_str)

    def on_message(self, message: Any) -> None:
        """Print one message."""
        if not self._passes(message):
            return
        for name in self._fields:
            message = _member(message, name)
        say(self._text(message), '\n' if self._arguments.csv else '---\n')
        if self._arguments.once:
            self._done.set_result(True)

    def _text(self, message: Any) -> str:
        if not isinstance(message, Message):
            return f'{message!r}\n' if isinstance(message, bytes) else f'{plain_value(message, self._short)}\n'
        if self._arguments.csv:
            return message_csv(message, self._short)
        return message_yaml(message, self._short, flow_style=self._arguments.flow_style)


def _member(message: Any, name: str) -> Any:
    """A field, also of the form `points[0]`.

    :raises RuntimeError: when there is no such field; in the words of ROS 2.
    """
    name, bracket, index = name.partition('[')
    try:
        value = getattr(message, name)
        return value[int(index.rstrip(']'))] if bracket else value
    except (AttributeError, IndexError, ValueError):
        known = ', '.join(getattr(message, '_FIELDS', ()))
        raise RuntimeError(
            f"Invalid field '{name}{bracket}{index}': {type(message).__name__} has no such field"
            f'\n  help: its fields are: {known or "(none)"}'
        ) from None


def _suitable_profile(node: Node, topic: str, arguments: argparse.Namespace) -> QoSProfile:
    """Sensor data, but as reliable and as durable as all publishers are; what only some offer is said."""
    from rclpy.qos import DurabilityPolicy, ReliabilityPolicy

    profile = qos_options.profile(arguments)
    offered = [endpoint.qos_profile for endpoint in node.get_publishers_info_by_topic(topic)]
    if qos_options.is_chosen(arguments) or not offered:
        return profile
    reliable = sum(each.reliability == ReliabilityPolicy.RELIABLE for each in offered)
    kept = sum(each.durability == DurabilityPolicy.TRANSIENT_LOCAL for each in offered)
    for count, policy, falls_back in (
        (reliable, 'ReliabilityPolicy.RELIABLE', 'ReliabilityPolicy.BEST_EFFORT'),
        (kept, 'DurabilityPolicy.TRANSIENT_LOCAL', 'DurabilityPolicy.VOLATILE'),
    ):
        if 0 < count < len(offered):
            complain(
                f'Some, but not all, publishers are offering {policy}. '
                f'Falling back to {falls_back} as it will connect to all publishers'
            )
    profile.reliability = ReliabilityPolicy.RELIABLE if reliable == len(offered) else ReliabilityPolicy.BEST_EFFORT
    profile.durability = DurabilityPolicy.TRANSIENT_LOCAL if kept == len(offered) else DurabilityPolicy.VOLATILE
    return profile
