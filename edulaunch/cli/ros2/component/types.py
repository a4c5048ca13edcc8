"""`ros2 component types`: which components packages have."""

from __future__ import annotations

import argparse
import os

from edulaunch.cli.ros2.component_containers import RESOURCE_TYPE
from edulaunch.cli.ros2.names import say_lines
from edulaunch.cli.ros2.output import say, with_help
from edulaunch.nearest import did_you_mean
from edulaunch.processes.current import current_process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """One package, or all."""
    parser.add_argument('package_name', nargs='?', help='Package name to list components from')


def main(arguments: argparse.Namespace) -> str | None:
    """Print the types, under the name of their package when no package is given."""
    wanted, packages = arguments.package_name, _registered()
    if wanted is not None and wanted not in packages:
        return with_help(f"Cannot find package '{wanted}' or it has no components", did_you_mean(wanted, packages))
    for package in sorted(packages) if wanted is None else [wanted]:
        found = packages[package]
        if wanted is None:
            say(package)
        say_lines(found if wanted is not None else [f'  {name}' for name in found])
    return None


def _registered() -> dict[str, list[str]]:
    """The types of each package, as its components.txt or, for an installed one, the ament index lists them."""
    from ament_index_python import get_resource, get_resources

    index, found = current_process().index, {}
    for package in index.packages():
        path = os.path.join(index.share(package) or '', 'components.txt')
        if os.path.isfile(path):
            with open(path, encoding='utf-8') as file:
                found[package] = [line.partition(' = ')[0] for line in file.read().splitlines() if line.strip()]
    for package in get_resources(RESOURCE_TYPE):
        text = get_resource(RESOURCE_TYPE, package)[0]
        found.setdefault(package, [line.partition(';')[0] for line in text.splitlines() if line.strip()])
    return found
