"""`ros2 interface`: list messages, services and actions, and show their definitions."""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from edulaunch.desk.cli.ros2.output import say, say_lines, with_help
from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.interfaces.registry import Registry
from edulaunch.engine.interfaces.spec import InterfaceSpec, MessageSpec, ServiceSpec
from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import InterfaceError
from edulaunch.ros.serialization.message_text import message_yaml

KINDS = (('msg', 'Messages'), ('srv', 'Services'), ('action', 'Actions'))


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 interface list`."""
    for kind, heading in KINDS:
        parser.add_argument(
            f'-{kind[0]}', f'--only-{kind}s', dest=kind, action='store_true', help=f'Print out only {heading.lower()}'
        )


def list_verb(arguments: argparse.Namespace) -> None:
    """Print the messages, services and actions, each kind below a heading."""
    chosen = [kind for kind, _ in KINDS if getattr(arguments, kind)]
    for kind, heading in KINDS:
        if not chosen or kind in chosen:
            say(f'{heading}:')
            say_lines([f'    {name}' for name in current_registry().types(kind)])


def package_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 interface package`."""
    parser.add_argument('package_name', help="Name of the ROS package (e.g. 'example_interfaces')")


def package_verb(arguments: argparse.Namespace) -> str | None:
    """Print the types of one package."""
    registry, package = current_registry(), arguments.package_name
    if not registry.has(package):
        return with_help(f"Unknown package '{package}'", did_you_mean(package, registry.packages()))
    say_lines([f'{package}/{kind}/{name}' for kind in ('action', 'msg', 'srv') for name in registry.names(package, kind)])
    return None


def packages_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 interface packages`."""
    list_arguments(parser)


def packages_verb(arguments: argparse.Namespace) -> None:
    """Print the names of the packages that contain interfaces, in alphabetical order."""
    registry = current_registry()
    chosen = [kind for kind, _ in KINDS if getattr(arguments, kind)]
    say_lines([name for name in registry.packages() if not chosen or any(registry.has(name, kind) for kind in chosen)])


def proto_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 interface proto`."""
    parser.add_argument('type', help="Show an interface prototype (e.g. 'example_interfaces/msg/String')")
    parser.add_argument('--no-quotes', action='store_true', help='if true output has no outer quotes.')


def proto_verb(arguments: argparse.Namespace) -> None:
    """Print a message with its default values. For a service, print the request, and for an action the goal."""
    cls = current_registry().get(arguments.type)
    cls = getattr(cls, 'Request', getattr(cls, 'Goal', cls))
    text = message_yaml(cls())
    say(text.rstrip('\n') if arguments.no_quotes else f'"{text}"')


def show_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 interface show`."""
    parser.add_argument('type', help="Show an interface definition (e.g. 'example_interfaces/msg/String')")
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        '--all-comments', action='store_true', help='Show all comments, including for nested interface definitions'
    )
    group.add_argument('--no-comments', action='store_true', help='Show no comments or whitespace')


def show_verb(arguments: argparse.Namespace) -> str | None:
    """Print the file of the type. Below each nested field, print the definition of its type, indented by a tab."""
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
    """Return the types of the fields that contain other messages, by the line of the field in the file."""
    parts = (
        (spec,)
        if isinstance(spec, MessageSpec)
        else (spec.request, spec.response)
        if isinstance(spec, ServiceSpec)
        else (spec.goal, spec.result, spec.feedback)
    )
    return {field.line: field.type.base for part in parts for field in part.fields if field.type.kind is None}


def _without_comment(line: str) -> str:
    """Return the line up to the first # outside quotation marks."""
    quote = ''
    for position, character in enumerate(line):
        if quote:
            quote = '' if character == quote else quote
        elif character in '"\'':
            quote = character
        elif character == '#':
            return line[:position].rstrip()
    return line
