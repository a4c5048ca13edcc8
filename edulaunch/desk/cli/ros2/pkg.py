"""`ros2 pkg`: list packages, their folders and their programs, and create a package."""

from __future__ import annotations

import argparse
import os

from edulaunch.desk.cli.ros2.output import say, say_lines, with_help
from edulaunch.engine.nearest import did_you_mean
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import PackageError


def create_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 pkg create`."""
    from edulaunch.desk.cli.pkg import add_create_arguments

    add_create_arguments(parser)


def create_verb(arguments: argparse.Namespace) -> str | None:
    """Create the package below the folder in which the command runs, and print the names of the created files."""
    from edulaunch.advice.workspace.new_package import create_package
    from edulaunch.desk.cli.pkg import described_package

    process = current_process()
    user = process.env.get('USER') or 'user'
    arguments.destination_directory = os.path.join(process.cwd or os.curdir, arguments.destination_directory)
    try:
        create_package(described_package(arguments, user, f'{user}@todo.todo'), say)
    except PackageError as error:
        return str(error)
    return None


def executables_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 pkg executables`."""
    parser.add_argument('package_name', nargs='?', help='Name of the package to list its executables')
    parser.add_argument('--full-path', action='store_true', help='Show the full path of each executable')


def executables_verb(arguments: argparse.Namespace) -> str | None:
    """Print each executable after the name of its package."""
    index, wanted = current_process().index, arguments.package_name
    packages = sorted(index.packages())
    if wanted is not None and wanted not in packages:
        return with_help('Package not found', did_you_mean(wanted, packages))
    for package in packages if wanted is None else [wanted]:
        for executable in index.executables(package):
            path = index.find_executable(package, executable)
            say_lines([str(path) if arguments.full_path else f'{package} {executable}'])
    return None


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add no arguments, because `ros2 pkg list` has no arguments."""


def list_verb(arguments: argparse.Namespace) -> None:
    """Print the names of the packages in alphabetical order."""
    say_lines(sorted(current_process().index.packages()))


def prefix_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 pkg prefix`."""
    parser.add_argument('package_name', help='The package name')
    parser.add_argument('--share', action='store_true', help='Show share directory for the package')


def prefix_verb(arguments: argparse.Namespace) -> str | None:
    """Print the prefix of the package. With `--share`, print its share directory."""
    index, package = current_process().index, arguments.package_name
    place = index.share(package) if arguments.share else index.prefix(package)
    if place is None:
        return with_help('Package not found', did_you_mean(package, index.packages()))
    say(place)
    return None


def xml_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 pkg xml`."""
    parser.add_argument('package_name', help='The package name')
    parser.add_argument('-t', '--tag', help='The XML tag to output, e.g. version')


def xml_verb(arguments: argparse.Namespace) -> str | None:
    """Print the package.xml of the package, or the content of one tag."""
    from xml.etree import ElementTree

    index, package = current_process().index, arguments.package_name
    share = index.share(package)
    if share is None:
        return with_help('Package not found', did_you_mean(package, index.packages()))
    path = os.path.join(share, 'package.xml')
    if not os.path.isfile(path):
        return with_help(f"Package '{package}' has no package.xml", 'it is built into edulaunch')
    if arguments.tag is None:
        with open(path, encoding='utf-8') as file:
            say(file.read())
        return None
    found = ElementTree.parse(path).getroot().findall(arguments.tag)
    if not found:
        return f"No element found for '{arguments.tag}' in the package manifest of '{package}'"
    for element in found:
        say(element.text or '')
    return None
