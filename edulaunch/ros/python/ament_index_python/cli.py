"""The `ament_index` command. It lists resource types or the resources of a type, or shows one resource."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from typing import Any

from .resources import get_resource, get_resource_types, get_resources


def resource_type_completer(prefix: str, **_: Any) -> Iterable[str]:
    """Return the types of resources with this prefix, for shell completion."""
    return (name for name in sorted(get_resource_types()) if name.startswith(prefix))


def resource_name_completer(prefix: str, parsed_args: Any, **_: Any) -> Iterable[str]:
    """Return the resources with this prefix and with the type in the command line. Without a type, return no resources.

    :param parsed_args: the arguments that are already parsed, with `resource_type`.
    """
    resource_type = getattr(parsed_args, 'resource_type', None)
    return (name for name in sorted(get_resources(resource_type)) if name.startswith(prefix)) if resource_type else []


def main(argv: list[str] | None = None) -> str | None:
    """Run the command.

    :returns: None, or the error message with which the program exits.
    """
    import argparse

    parser = argparse.ArgumentParser(description='Query the ament resource index.')
    kind: Any = parser.add_argument(
        'resource_type', nargs='?', metavar='TYPE', help='the type of resource; without it all types are listed'
    )
    kind.completer = resource_type_completer
    name: Any = parser.add_argument(
        'resource_name', nargs='?', metavar='NAME', help='the name of a resource; without it all of the type are listed'
    )
    name.completer = resource_name_completer
    args = parser.parse_args(sys.argv[1:] if argv is None else argv)
    if args.resource_type is None:
        _print_lines(get_resource_types())
        return None
    if args.resource_name is None:
        resources = get_resources(args.resource_type)
        _print_lines(f'{name}\t{prefix}' for name, prefix in resources.items())
        return None
    try:
        content, prefix = get_resource(args.resource_type, args.resource_name)
    except (LookupError, OSError) as error:
        return str(error)
    print(prefix)
    if content:
        print(f'<<<\n{content}\n>>>')
    return None


def _print_lines(lines: Iterable[str]) -> None:
    for line in sorted(lines):
        print(line)
