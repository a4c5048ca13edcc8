"""`edulaunch env`: where ROS's import packages are; with `--shell` what makes them importable in a shell."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Mapping

from edulaunch.packages.discovery import find_workspaces
from edulaunch.underlay_place import underlay_prefix, underlay_python


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What to print."""
    parser.add_argument(
        '--shell',
        action='store_true',
        help='print what to evaluate in a shell: eval "$(edulaunch env --shell)", then python3 node.py',
    )


def main(arguments: argparse.Namespace) -> int:
    """Print the folder with `rclpy`, `launch` ... for the settings of editors and type checkers; or lines for a shell."""
    if not arguments.shell:
        print(underlay_python())
        return 0
    from shlex import quote

    for name, value in sorted(sourced_environment(os.environ).items()):
        print(f'export {name}={quote(value)}')
    return 0


def sourced_environment(env: Mapping[str, str]) -> dict[str, str]:
    """The variables that a shell, or a program, needs so that Python finds `rclpy` and the packages of the workspaces here."""
    workspaces = find_workspaces(os.getcwd(), env)
    first = {
        'PATH': [os.path.dirname(sys.executable)],
        'PYTHONPATH': [os.path.join(underlay_prefix(), 'shell'), underlay_python()],
        'AMENT_PREFIX_PATH': [underlay_prefix()],
    }
    found = {
        name: os.pathsep.join(dict.fromkeys([*paths, *filter(None, env.get(name, '').split(os.pathsep))]))
        for name, paths in first.items()
    }
    found.update(ROS_DISTRO='jazzy', ROS_VERSION='2', ROS_PYTHON_VERSION='3')
    if workspaces:
        found['EDULAUNCH_WORKSPACES'] = os.pathsep.join(workspaces)
    return found
