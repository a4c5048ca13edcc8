"""`edulaunch pkg create` creates a package as `ros2 pkg create` does. `edulaunch pkg check` finds common mistakes."""

from __future__ import annotations

import argparse
import os
import sys
from typing import TYPE_CHECKING

from edulaunch.errors import PackageError, UnusableInput

if TYPE_CHECKING:
    from edulaunch.advice.workspace.package_files import NewPackage


def pkg_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the sub-verbs of `edulaunch pkg`."""
    verbs = parser.add_subparsers(dest='what', metavar='create | check', required=True)
    add_create_arguments(verbs.add_parser('create', help='create a new ROS 2 package'))
    check = verbs.add_parser('check', help='look for common mistakes in packages')
    check.add_argument('path', nargs='?', default='.', metavar='PATH', help='a workspace or a package (default: this folder)')


def add_create_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of `ros2 pkg create`."""
    from edulaunch.advice.workspace.new_package import BUILD_TYPES
    from edulaunch.advice.workspace.package_files import NewPackage

    parser.add_argument('package_name', help='the package name')
    parser.add_argument('--package-format', '--package_format', choices=['2', '3'], default='3', help='the format of package.xml')
    parser.add_argument('--description', default=NewPackage.description, help='the description given in package.xml')
    parser.add_argument('--license', default=NewPackage.license, help='the license, such as Apache-2.0')
    parser.add_argument('--destination-directory', default=os.curdir, help='where to create the package (default: here)')
    parser.add_argument('--build-type', choices=BUILD_TYPES, help=f'how the package is built (default: {NewPackage.build_type})')
    parser.add_argument('--dependencies', nargs='+', action='extend', default=[], help='packages that it depends on')
    parser.add_argument('--maintainer-email', help='email address of the maintainer')
    parser.add_argument('--maintainer-name', help='name of the maintainer')
    parser.add_argument('--node-name', help='create an empty node with this name, too')
    parser.add_argument('--library-name', help='create an empty library with this name, too')


def pkg_verb(arguments: argparse.Namespace) -> int:
    """Create a package or check packages. Return 1 if there are findings or the package could not be created, otherwise 0."""
    return create(arguments) if arguments.what == 'create' else check(arguments.path)


def create(arguments: argparse.Namespace) -> int:
    """Create a package, and print the names of the created files. Return the exit code."""
    from edulaunch.advice.workspace.new_package import create_package

    try:
        create_package(described_package(arguments, *maintainer()), print)
    except PackageError as error:
        print(error, file=sys.stderr)
        return 1
    if arguments.build_type is None and is_in_course(arguments.destination_directory):
        words = f'ros2 pkg create {arguments.package_name} --build-type ament_python'
        print(f'\nThis package is for C++ and CMake. For a Python package, delete it and type: {words}', file=sys.stderr)
    return 0


def is_in_course(folder: str) -> bool:
    """Return whether a folder belongs to a copy of the course. All packages of the course are Python packages."""
    here = os.path.abspath(folder)
    while True:
        if any(os.path.isfile(os.path.join(here, *place)) for place in (('course.toml',), ('exercises', 'course.toml'))):
            return True
        if os.path.dirname(here) == here:
            return False
        here = os.path.dirname(here)


def described_package(arguments: argparse.Namespace, name: str, email: str) -> NewPackage:
    """Return the package that the options describe.

    :param name: the name of the maintainer, if no option sets it.
    :param email: the address of the maintainer, if no option sets it.
    """
    from edulaunch.advice.workspace.package_files import NewPackage

    return NewPackage(
        arguments.package_name,
        arguments.destination_directory,
        arguments.build_type or NewPackage.build_type,
        arguments.license,
        arguments.description,
        tuple(arguments.dependencies),
        arguments.maintainer_name or name,
        arguments.maintainer_email or email,
        arguments.node_name,
        arguments.library_name,
    )


def maintainer() -> tuple[str, str]:
    """Return the user's name from the operating system and the user's email address from git, as `ros2 pkg create` does."""
    import getpass
    import subprocess

    try:
        name = getpass.getuser()
    except (OSError, KeyError):
        name = 'user'
    try:
        words = ['git', 'config', '--global', 'user.email']
        email = subprocess.run(words, capture_output=True, text=True, timeout=5, check=False).stdout.strip()
    except (OSError, subprocess.SubprocessError):
        email = ''
    return name, email or f'{name}@todo.todo'


def check(path: str) -> int:
    """Print the mistakes in the packages below `path`. Return 1 if there are mistakes, otherwise 0.

    :raises UnusableInput: when `path` is not a folder.
    """
    from edulaunch.advice.judging import judge_workspace
    from edulaunch.advice.reader import reader_here
    from edulaunch.advice.rendering import rendered
    from edulaunch.advice.source_package import workspace_at

    if not os.path.isdir(path):
        raise UnusableInput(f'{path!r} is not a folder.', help='name a workspace, or the folder of a package')
    workspace = workspace_at(path)
    findings = judge_workspace(workspace)
    reader = reader_here()._replace(folder=workspace.path)
    for finding in findings:
        words = rendered(finding, reader)
        print(f'{words.where}: {words.what}\n  help: {words.do}')
    names, count = [package.name for package in workspace.packages], len(findings)
    print(
        f'{len(names)} package{"s" * (len(names) != 1)} checked'
        + (f' ({", ".join(names)})' if names else '')
        + f': {count or "no"} finding{"s" * (count != 1)}'
    )
    return 1 if findings else 0
