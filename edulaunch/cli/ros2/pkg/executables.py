"""`ros2 pkg executables`: the programs of one package or of all."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.names import say_lines
from edulaunch.cli.ros2.output import with_help
from edulaunch.nearest import did_you_mean
from edulaunch.processes.current import current_process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 pkg executables`."""
    parser.add_argument('package_name', nargs='?', help='Name of the package to list its executables')
    parser.add_argument('--full-path', action='store_true', help='Show the full path of each executable')


def main(arguments: argparse.Namespace) -> str | None:
    """Print each with its package."""
    index, wanted = current_process().index, arguments.package_name
    packages = sorted(index.packages())
    if wanted is not None and wanted not in packages:
        return with_help('Package not found', did_you_mean(wanted, packages))
    for package in packages if wanted is None else [wanted]:
        for executable in index.executables(package):
            path = index.find_executable(package, executable)
            say_lines([str(path) if arguments.full_path else f'{package} {executable}'])
    return None
