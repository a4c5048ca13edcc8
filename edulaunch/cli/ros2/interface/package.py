"""`ros2 interface package`: the interfaces of one package."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.names import say_lines
from edulaunch.cli.ros2.output import with_help
from edulaunch.interfaces import current_registry
from edulaunch.nearest import did_you_mean


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 interface package`."""
    parser.add_argument('package_name', help="Name of the ROS package (e.g. 'example_interfaces')")


def main(arguments: argparse.Namespace) -> str | None:
    """Print their types, sorted."""
    registry, package = current_registry(), arguments.package_name
    if not registry.has(package):
        return with_help(f"Unknown package '{package}'", did_you_mean(package, registry.packages()))
    say_lines([f'{package}/{kind}/{name}' for kind in ('action', 'msg', 'srv') for name in registry.names(package, kind)])
    return None
