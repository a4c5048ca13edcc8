"""`ros2 interface list`: which interfaces there are."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.names import say_lines
from edulaunch.cli.ros2.output import say
from edulaunch.interfaces import current_registry

KINDS = (('msg', 'Messages'), ('srv', 'Services'), ('action', 'Actions'))


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 interface list`."""
    for kind, heading in KINDS:
        parser.add_argument(
            f'-{kind[0]}', f'--only-{kind}s', dest=kind, action='store_true', help=f'Print out only {heading.lower()}'
        )


def main(arguments: argparse.Namespace) -> None:
    """Print the types of each kind under a heading."""
    chosen = [kind for kind, _ in KINDS if getattr(arguments, kind)]
    for kind, heading in KINDS:
        if not chosen or kind in chosen:
            say(f'{heading}:')
            say_lines([f'    {name}' for name in current_registry().types(kind)])
