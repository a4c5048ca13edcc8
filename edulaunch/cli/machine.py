"""`edulaunch machine`: words to the machine that the terminals of this user and domain share."""

from __future__ import annotations

import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the machine shall do."""
    parser.add_argument('word', choices=('status', 'pause', 'resume', 'speed', 'stop'), nargs='?', default='status')
    parser.add_argument('value', nargs='?', help='for speed: simulated seconds per second')


def main(arguments: argparse.Namespace) -> int:
    """Tell it; 1 when no machine is running."""
    from edulaunch.machine.client import run

    words = ['machine', arguments.word] + ([arguments.value] if arguments.value else [])
    return run(words, start=False)
