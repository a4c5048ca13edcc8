"""Where the underlay is: the built-in packages, laid out like a ROS install prefix."""

from __future__ import annotations

import os


def underlay_prefix() -> str:
    """The prefix folder; below it `python/` (import packages) and `share/` (package data)."""
    return os.path.join(os.path.dirname(os.path.abspath(__file__)), 'underlay')


def underlay_python() -> str:
    """The folder that `edulaunch.source()` puts on the path."""
    return os.path.join(underlay_prefix(), 'python')


_SOURCED: list[str] = []


def put_on_prefix_path() -> None:
    """Add the underlay to this interpreter's AMENT_PREFIX_PATH, as sourcing ROS 2 does."""
    folders = [folder for folder in os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if folder]
    if underlay_prefix() not in folders:
        folders.append(underlay_prefix())
    os.environ['AMENT_PREFIX_PATH'] = os.pathsep.join(folders)
    _SOURCED[:] = [os.environ['AMENT_PREFIX_PATH']]


def sourced_path() -> str:
    """AMENT_PREFIX_PATH as sourcing left it in this interpreter, whatever a program has made of it since."""
    return _SOURCED[0] if _SOURCED else os.environ.get('AMENT_PREFIX_PATH', '')
