"""`ros2 pkg prefix`: where a package is installed."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.output import say, with_help
from edulaunch.nearest import did_you_mean
from edulaunch.processes.current import current_process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 pkg prefix`."""
    parser.add_argument('package_name', help='The package name')
    parser.add_argument('--share', action='store_true', help='Show share directory for the package')


def main(arguments: argparse.Namespace) -> str | None:
    """Print the prefix, or the share directory."""
    index, package = current_process().index, arguments.package_name
    place = index.share(package) if arguments.share else index.prefix(package)
    if place is None:
        return with_help('Package not found', did_you_mean(package, index.packages()))
    say(place)
    return None
