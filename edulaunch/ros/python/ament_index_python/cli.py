"""The `ament_index` command: list resource types, resources of a type, or show one resource."""

from __future__ import annotations

import sys

from .resources import get_resource, get_resource_types, get_resources


def main(argv: list[str] | None = None) -> str | None:
    """Run the command.

    :returns: None, or the error to exit with.
    """
    import argparse

    parser = argparse.ArgumentParser(prog='ament_index', description='Query the ament resource index.')
    parser.add_argument('resource_type', nargs='?', help='the type of resource; without it all types are listed')
    parser.add_argument('resource_name', nargs='?', help='the name of a resource; without it all of the type are listed')
    args = parser.parse_args(sys.argv[1:] if argv is None else argv)
    if args.resource_type is None:
        print('\n'.join(sorted(get_resource_types())))
        return None
    if args.resource_name is None:
        resources = get_resources(args.resource_type)
        print('\n'.join(f'{name}\t{prefix}' for name, prefix in sorted(resources.items())))
        return None
    try:
        content, prefix = get_resource(args.resource_type, args.resource_name)
    except LookupError as error:
        return str(error)
    print(prefix)
    if content:
        print(f'<<<\n{content}\n>>>')
    return None
