"""Functions for verbs that subscribe to a topic: they find its class, filter and print messages, and read the QoS options."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names
from edulaunch.desk.cli.ros2.fill_message import interface_class
from edulaunch.desk.cli.ros2.output import complain, say, with_help
from edulaunch.engine.interfaces.message import Message
from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import InterfaceError
from edulaunch.ros.serialization.message_text import Shortening, message_csv, message_yaml, plain_value

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.qos import QoSProfile

UNKNOWN = 'Could not determine the type for the passed topic'
LONGEST = 128
PRESETS = (
    'unknown',
    'default',
    'system_default',
    'sensor_data',
    'services_default',
    'parameters',
    'parameter_events',
    'action_status_default',
    'best_available',
)
POLICIES = {
    'history': ('system_default', 'keep_last', 'keep_all'),
    'reliability': ('system_default', 'reliable', 'best_effort', 'best_available'),
    'durability': ('system_default', 'transient_local', 'volatile', 'best_available'),
    'liveliness': ('system_default', 'automatic', 'manual_by_topic', 'best_available'),
}


def topic_class(node: Node, topic: str, type_text: str | None, *, verb: str, wait: bool = False) -> Any:
    """Return the message class of a topic, or an error message if it cannot be determined.

    :param node: the node of the command.
    :param topic: the name of the topic.
    :param type_text: the type that the user names. If None, use the type that the graph has for the topic.
    :param verb: the name of the verb for error messages, such as 'echo'.
    :param wait: whether to wait until the topic appears.
    """
    if type_text is not None:
        try:
            return interface_class(type_text, 'msg')
        except InterfaceError as error:
            return with_help('The passed message type is invalid', error.help)
    name = node.resolve_topic_name(topic)
    types = _types(node, name)
    if not types:
        complain(f'WARNING: topic [{name}] does not appear to be published yet')
        while wait and not types and cli_node.pause(node, 0.1):
            types = _types(node, name)
    if not types:
        return with_help(UNKNOWN, did_you_mean(name, [known for known, _ in node.get_topic_names_and_types()]))
    if len(types) > 1:
        return f"Cannot {verb} topic '{topic}', as it contains more than one type: [{', '.join(types)}]"
    return interface_class(types[0], 'msg')


def _types(node: Node, name: str) -> list[str]:
    return graph_names.types_of(name, node.get_topic_names_and_types())


def message_filter(expression: str | None) -> Callable[[Any], bool]:
    """Return a function that tests whether to show a message. Without an expression, it returns True for all messages.

    As in ROS 2, the expression is Python code of the user, and the message is `m`.

    :raises RuntimeError: for an invalid expression. The returned function raises RuntimeError when the expression fails for
        a message.
    """
    if expression is None:
        return lambda message: True
    try:
        code = compile(expression, '--filter', 'eval')
    except SyntaxError as error:
        raise RuntimeError(f'Invalid filter expression: {expression}\n  help: {error.msg}; as in: m.x > 1') from None

    def passes(message: Any) -> bool:
        try:
            return bool(eval(code, {'m': message}))
        except Exception as error:
            raise RuntimeError(f'Filter expression failed: {type(error).__name__}: {error}') from None

    return passes


def add_printing_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options that choose parts of a message and the format of the output."""
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


class Printer:
    """Prints messages, or the fields that the options choose. With `--once`, `done` is set after the first printed message."""

    def __init__(self, arguments: argparse.Namespace, done: Any) -> None:
        self._arguments = arguments
        self._done = done
        self._fields = [name for name in (arguments.field or '').split('.') if name]
        self._passes = message_filter(arguments.filter)
        length = None if arguments.full_length else arguments.truncate_length
        self._short = Shortening(length, arguments.no_arr, arguments.no_str)

    def on_message(self, message: Any) -> None:
        """Print one message if it passes the filter."""
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
    """Return the field of a message, or one element of it if `name` has the form `points[0]`.

    :raises RuntimeError: for an unknown field, with the message of ROS 2.
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


def add_qos_arguments(parser: argparse.ArgumentParser, default: str) -> None:
    """Add an option for a QoS preset, and options that override single policies."""
    parser.add_argument(
        '--qos-profile', choices=PRESETS, default=default, help=f'Quality of service preset profile (default: {default})'
    )
    parser.add_argument('--qos-depth', metavar='N', type=int, help='Queue size setting (overrides depth of the profile)')
    for policy, values in POLICIES.items():
        parser.add_argument(
            f'--qos-{policy}', choices=values, help=f'Quality of service {policy} setting (overrides the profile)'
        )


def is_qos_chosen(arguments: argparse.Namespace) -> bool:
    """Return whether the command line sets reliability or durability."""
    return arguments.qos_reliability is not None or arguments.qos_durability is not None


def qos_profile(arguments: argparse.Namespace) -> QoSProfile:
    """Return the QoS profile that the options describe."""
    from rclpy import qos

    preset = qos.QoSPresetProfiles.get_from_short_key(arguments.qos_profile)
    values: dict[str, Any] = {name: getattr(preset, name) for name in ('depth', *POLICIES)}
    kinds = {
        'history': qos.HistoryPolicy,
        'reliability': qos.ReliabilityPolicy,
        'durability': qos.DurabilityPolicy,
        'liveliness': qos.LivelinessPolicy,
    }
    for policy, kind in kinds.items():
        key = getattr(arguments, f'qos_{policy}')
        if key is not None:
            values[policy] = kind.get_from_short_key(key)
    if arguments.qos_depth is not None:
        values['depth'] = arguments.qos_depth
    return qos.QoSProfile(**values)
