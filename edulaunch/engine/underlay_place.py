"""The place of the underlay: the built-in packages, with the layout of a ROS install prefix."""

from __future__ import annotations

import os


def engine_folder() -> str:
    """Return the folder of the package edulaunch."""
    return os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def underlay_prefix() -> str:
    """Return the prefix folder; below it `python/` (import packages) and `share/` (package data)."""
    return os.path.join(engine_folder(), 'ros')


def underlay_python() -> str:
    """Return the folder that `edulaunch.source()` puts on the path."""
    return os.path.join(underlay_prefix(), 'python')


def is_students(filename: str) -> bool:
    """Return whether a file belongs neither to edulaunch nor to Python nor to an installed package. Files in the underlay's
    `share/` count as a student's.
    """
    python = os.path.dirname(os.path.abspath(os.__file__)) + os.sep
    if filename.startswith(('<', python)) or 'site-packages' in filename or filename.endswith('.pyx'):
        return False
    shared = os.path.join(underlay_prefix(), 'share') + os.sep
    return filename.startswith(shared) or not filename.startswith(engine_folder() + os.sep)
