"""`ros2 interface proto`: an interface's fields as YAML, ready to be filled in."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.output import say
from edulaunch.interfaces import current_registry
from edulaunch.interfaces.message_text import message_yaml


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 interface proto`."""
    parser.add_argument('type', help="Show an interface prototype (e.g. 'example_interfaces/msg/String')")
    parser.add_argument('--no-quotes', action='store_true', help='if true output has no outer quotes.')


def main(arguments: argparse.Namespace) -> None:
    """Print what a new message holds; of a service the request, of an action the goal."""
    cls = current_registry().get(arguments.type)
    cls = getattr(cls, 'Request', getattr(cls, 'Goal', cls))
    text = message_yaml(cls())
    say(text.rstrip('\n') if arguments.no_quotes else f'"{text}"')
