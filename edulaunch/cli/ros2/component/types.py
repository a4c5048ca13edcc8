"""`ros2 component types`: which components packages have."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.component_containers import RESOURCE_TYPE
from edulaunch.cli.ros2.names import say_lines
from edulaunch.cli.ros2.output import say, with_help
from edulaunch.nearest import did_you_mean


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """One package, or all."""
    parser.add_argument('package_name', nargs='?', help='Package name to list components from')


def main(arguments: argparse.Namespace) -> str | None:
    """Print the types, under the name of their package when no package is given."""
    from ament_index_python import get_resource, get_resources

    wanted, packages = arguments.package_name, sorted(get_resources(RESOURCE_TYPE))
    if wanted is not None and wanted not in packages:
        return with_help(f"Cannot find package '{wanted}' or it has no components", did_you_mean(wanted, packages))
    for package in packages if wanted is None else [wanted]:
        found = [line.partition(';')[0] for line in get_resource(RESOURCE_TYPE, package)[0].splitlines() if line.strip()]
        if wanted is None:
            say(package)
        say_lines(found if wanted is not None else [f'  {name}' for name in found])
    return None
