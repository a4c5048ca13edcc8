"""`edulaunch colcon build` and the like: says that nothing has to be built, and what is done instead."""

from __future__ import annotations

import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Whatever colcon takes."""
    parser.add_argument('rest', nargs=argparse.REMAINDER, metavar='WORD', help='what you would tell colcon')


def main(arguments: argparse.Namespace) -> int:
    """Print one sentence. Always 0: the tutorial goes on with its next command."""
    from edulaunch.workspace.not_needed import answer

    print(answer(['colcon', *(arguments.rest or ['build'])]))
    return 0
