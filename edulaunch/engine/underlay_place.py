"""Where the underlay is: the built-in packages, laid out like a ROS install prefix."""

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
    """Whether a file is neither ours nor Python's nor of an installed package. What the underlay shares is as a student's."""
    python = os.path.dirname(os.path.abspath(os.__file__)) + os.sep
    if filename.startswith(('<', python)) or 'site-packages' in filename or filename.endswith('.pyx'):
        return False
    shared = os.path.join(underlay_prefix(), 'share') + os.sep
    return filename.startswith(shared) or not filename.startswith(engine_folder() + os.sep)
