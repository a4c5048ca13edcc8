"""Where the underlay is: the built-in packages, laid out like a ROS install prefix."""

from __future__ import annotations

import os
from collections.abc import Sequence


def engine_folder() -> str:
    """The folder of the package edulaunch."""
    return os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def underlay_prefix() -> str:
    """The prefix folder; below it `python/` (import packages) and `share/` (package data)."""
    return os.path.join(engine_folder(), 'ros')


def underlay_python() -> str:
    """The folder that `edulaunch.source()` puts on the path."""
    return os.path.join(underlay_prefix(), 'python')


_SOURCED: list[str] = []
_WORKSPACES: list[str] = []


def put_on_prefix_path(prefixes: Sequence[str] = ()) -> None:
    """Put prefixes in front of this interpreter's AMENT_PREFIX_PATH, and the underlay behind it, as sourcing ROS 2 does."""
    before = [folder for folder in os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if folder]
    os.environ['AMENT_PREFIX_PATH'] = os.pathsep.join(dict.fromkeys((*prefixes, *before, underlay_prefix())))
    _SOURCED[:] = [os.environ['AMENT_PREFIX_PATH']]


def sourced_path() -> str:
    """AMENT_PREFIX_PATH as sourcing left it in this interpreter, whatever a program has made of it since."""
    return _SOURCED[0] if _SOURCED else os.environ.get('AMENT_PREFIX_PATH', '')


def note_sourced(workspaces: Sequence[str]) -> None:
    """Remember source workspaces that were sourced, for programs that this interpreter starts by itself."""
    _WORKSPACES.extend(path for path in workspaces if path not in _WORKSPACES)


def sourced_workspaces() -> list[str]:
    """The source workspaces that were sourced in this interpreter, in order of search."""
    return list(_WORKSPACES)
