"""`ros2 interface packages`: which packages have interfaces."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2.interface import list as listing
from edulaunch.cli.ros2.names import say_lines
from edulaunch.interfaces import current_registry


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 interface packages`."""
    listing.add_arguments(parser)


def main(arguments: argparse.Namespace) -> None:
    """Print them, sorted."""
    registry = current_registry()
    chosen = [kind for kind, _ in listing.KINDS if getattr(arguments, kind)]
    say_lines([name for name in registry.packages() if not chosen or any(registry.has(name, kind) for kind in chosen)])
