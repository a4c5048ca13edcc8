"""Where the underlay is: the built-in packages, laid out like a ROS install prefix."""

from __future__ import annotations

import os


def engine_folder() -> str:
    """The folder of the package edulaunch."""
    return os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def underlay_prefix() -> str:
    """The prefix folder; below it `python/` (import packages) and `share/` (package data)."""
    return os.path.join(engine_folder(), 'ros')


def underlay_python() -> str:
    """The folder that `edulaunch.source()` puts on the path."""
    return os.path.join(underlay_prefix(), 'python')
