"""`ros2 interface show`: the text of an interface, with that of the types it uses."""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from edulaunch.cli.ros2.names import say_lines
from edulaunch.cli.ros2.output import with_help
from edulaunch.errors import InterfaceError
from edulaunch.interfaces import current_registry
from edulaunch.interfaces.registry import Registry
from edulaunch.interfaces.spec import InterfaceSpec, MessageSpec, ServiceSpec


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 interface show`."""
    parser.add_argument('type', help="Show an interface definition (e.g. 'example_interfaces/msg/String')")
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        '--all-comments', action='store_true', help='Show all comments, including for nested interface definitions'
    )
    group.add_argument('--no-comments', action='store_true', help='Show no comments or whitespace')


def main(arguments: argparse.Namespace) -> str | None:
    """Print the file, each nested field followed by its definition, one tab further in."""
    registry, name = current_registry(), arguments.type
    package = name.partition('/')[0]
    try:
        say_lines(list(_lines(registry, name, 0, not arguments.no_comments, arguments.all_comments)))
    except InterfaceError as error:
        known = registry.has(package)
        return with_help(f"Could not find the interface '{name}'" if known else f"Unknown package '{package}'", error.help)
    return None


def _lines(registry: Registry, name: str, level: int, comments: bool, all_comments: bool) -> Iterator[str]:
    nested = _nested_types(registry.spec(name))
    for number, line in enumerate(registry.text(name).splitlines(), 1):
        shown = line if comments else _without_comment(line)
        if shown.strip() or comments:
            yield '\t' * level + shown if shown else ''
        if number in nested:
            yield from _lines(registry, nested[number], level + 1, all_comments, all_comments)


def _nested_types(spec: InterfaceSpec) -> dict[int, str]:
    """The types of fields that are interfaces themselves, by line of the file."""
    parts = (
        (spec,)
        if isinstance(spec, MessageSpec)
        else (spec.request, spec.response)
        if isinstance(spec, ServiceSpec)
        else (spec.goal, spec.result, spec.feedback)
    )
    return {field.line: field.type.base for part in parts for field in part.fields if field.type.kind is None}


def _without_comment(line: str) -> str:
    """The line up to the first # that stands in no quotation."""
    quote = ''
    for position, character in enumerate(line):
        if quote:
            quote = '' if character == quote else quote
        elif character in '"\'':
            quote = character
        elif character == '#':
            return line[:position].rstrip()
    return line
