"""`ros2 pkg create`: make a new package."""

from __future__ import annotations

import argparse
import os

from edulaunch.cli.pkg import add_create_arguments as add_arguments
from edulaunch.cli.pkg import described_package
from edulaunch.cli.ros2.output import say
from edulaunch.processes.current import current_process

__all__ = ['add_arguments', 'main']


def main(arguments: argparse.Namespace) -> str | None:
    """Make it below the folder of the program that asks, and say what is made."""
    from edulaunch.errors import PackageError
    from edulaunch.workspace.new_package import create_package

    process = current_process()
    user = process.env.get('USER') or 'user'
    arguments.destination_directory = os.path.join(process.cwd or os.curdir, arguments.destination_directory)
    try:
        create_package(described_package(arguments, user, f'{user}@todo.todo'), say)
    except PackageError as error:
        return str(error)
    return None
