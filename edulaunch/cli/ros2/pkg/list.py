"""`ros2 pkg list`: which packages there are."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.names import say_lines
from edulaunch.processes.current import current_process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """None, as in ROS 2."""


def main(arguments: argparse.Namespace) -> None:
    """Print their names, sorted."""
    say_lines(sorted(current_process().index.packages()))
