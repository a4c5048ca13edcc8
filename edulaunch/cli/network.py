"""`edulaunch network`: the real ROS 2 network, and what reaches it."""

from __future__ import annotations

import argparse
import sys

from edulaunch.native import environment


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What to do."""
    parser.add_argument('word', choices=('status', 'install'), nargs='?', default='status')


def main(arguments: argparse.Namespace) -> int:
    """Do it. `status` is 1 when the real rclpy is not installed."""
    if arguments.word == 'install':
        return _install()
    there = environment.found()
    if there is None:
        print(f'real rclpy: not installed ({environment.unsuited() or "edulaunch network install"})')
        return 1
    print(f'real rclpy: {there.version} in {there.place}')
    return 0


def _install() -> int:
    """Make the environment; on a terminal its steps overwrite each other."""
    live = sys.stderr.isatty()
    made = environment.install(lambda step: print(f'\r\x1b[K{step}' if live else step, end='' if live else '\n', file=sys.stderr))
    if live:
        print('\r\x1b[K', end='', file=sys.stderr)
    print(f'real rclpy: {made.version} in {made.place}')
    return 0
