"""`ros2 daemon start|status|stop`: there is none, and none is needed."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.output import say

ANSWERS = {'start': 'The daemon has not been started', 'status': 'The daemon is not running', 'stop': 'The daemon is not running'}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """There are none."""


def main(arguments: argparse.Namespace) -> None:
    """Print that it does not run, and why that is well."""
    say(f'{ANSWERS[arguments.verb]}: none is needed here, every command asks the simulated machine itself')
