"""How messages are printed: the options that `ros2 topic echo` and `ros2 service echo` share."""

from __future__ import annotations

import argparse
from typing import Any

from edulaunch.cli.ros2.message_filter import message_filter
from edulaunch.cli.ros2.output import say
from edulaunch.interfaces.message import Message
from edulaunch.interfaces.message_text import Shortening, message_csv, message_yaml, plain_value

LONGEST = 128


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Which parts of a message, and in which form."""
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
