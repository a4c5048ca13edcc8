"""Replacements for commands that set up a computer for ROS 2.

`edulaunch rosdep check` lists missing dependencies. `edulaunch colcon build` explains that no build is needed.
"""

from __future__ import annotations

import argparse
import os
import sys

from edulaunch.errors import UnusableInput


def rosdep_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the sub-verbs of `edulaunch rosdep`."""
    verbs = parser.add_subparsers(dest='what', metavar='check', required=True)
    check = verbs.add_parser('check', help='list dependencies that neither edulaunch nor the workspace provides')
    check.add_argument('path', nargs='?', default='.', metavar='PATH', help='a workspace or a package (default: this folder)')
    for verb in ('init', 'install', 'update'):
        other = verbs.add_parser(verb, help='explain why this is not needed')
        other.add_argument('rest', nargs='*', metavar='WORD', help='the arguments of rosdep')
        other.set_defaults(takes_anything=True)


def rosdep_verb(arguments: argparse.Namespace) -> int:
    """Print the missing dependencies. Return 1 if a dependency is missing, otherwise 0."""
    if arguments.what != 'check':
        from edulaunch.advice.workspace.not_needed import answer

        print(answer(['rosdep', arguments.what]))
        return 0
    from edulaunch.advice.workspace.dependencies import missing_dependencies

    if not os.path.isdir(arguments.path):
        raise UnusableInput(f'{arguments.path!r} is not a folder.', help='name a workspace, or the folder of a package')
    packages, missing = missing_dependencies(arguments.path)
    for package, (name, tag, line), near in missing:
        place = f'{os.path.relpath(package.manifest_file)}:{line}' if line else os.path.relpath(package.manifest_file)
        print(
            f'{place}: {package.name} needs {name} (<{tag}>), which is not installed'
            + (f'; the nearest name is {near}' if near else '')
        )
    if missing:
        names = ', '.join(dict.fromkeys(package.name for package, *_ in missing))
        print(f'\nnodes that use a missing dependency cannot run: {names}')
    elif packages:
        print('All dependencies have been satisfied')
    else:
        print(f'no package.xml below {arguments.path}')
    return 1 if missing or not packages else 0


def command() -> int:
    """Run the real `rosdep` if it is installed, otherwise `edulaunch rosdep`. Return the exit code."""
    from edulaunch.desk.cli.main import main as edulaunch
    from edulaunch.desk.machine.command import step_aside

    words = sys.argv[1:]
    step_aside('rosdep', words, words[:1] == ['--verbose'])
    return edulaunch(['rosdep', *words])


def colcon_arguments(parser: argparse.ArgumentParser) -> None:
    """Accept all command-line arguments of colcon."""
    parser.add_argument('rest', nargs=argparse.REMAINDER, metavar='WORD', help='the arguments of colcon')


def colcon_verb(arguments: argparse.Namespace) -> int:
    """Print why no build is needed. Return 0, so that the user can continue with the tutorial."""
    from edulaunch.advice.workspace.not_needed import answer

    print(answer(['colcon', *(arguments.rest or ['build'])]))
    return 0
