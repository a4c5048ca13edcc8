"""The prefixes and source workspaces that are sourced in this interpreter, like `setup.bash` in a terminal."""

from __future__ import annotations

import os
from collections.abc import Sequence

from edulaunch.engine.packages.index import Index
from edulaunch.engine.packages.reading import SourceReader
from edulaunch.engine.underlay_place import underlay_prefix


class _Sourced:
    """The workspaces and prefixes that were sourced in this interpreter; `path` has the value None at first."""

    def __init__(self) -> None:
        self.path: str | None = None
        self.workspaces: list[str] = []
        self.read_source: SourceReader | None = None


_SOURCED = _Sourced()


def put_on_prefix_path(prefixes: Sequence[str] = ()) -> None:
    """Add prefixes to the start of this interpreter's AMENT_PREFIX_PATH, and the underlay to its end, as sourcing ROS 2 does."""
    before = [folder for folder in os.environ.get('AMENT_PREFIX_PATH', '').split(os.pathsep) if folder]
    os.environ['AMENT_PREFIX_PATH'] = os.pathsep.join(dict.fromkeys((*prefixes, *before, underlay_prefix())))
    _SOURCED.path = os.environ['AMENT_PREFIX_PATH']


def sourced_path() -> str:
    """Return the AMENT_PREFIX_PATH that sourcing has set in this interpreter, even if a program has changed the variable
    since.
    """
    return os.environ.get('AMENT_PREFIX_PATH', '') if _SOURCED.path is None else _SOURCED.path


def add_workspaces(folders: Sequence[str], read_source: SourceReader) -> None:
    """Record source workspaces for programs that this interpreter starts by itself.

    :param folders: the source workspaces.
    :param read_source: the function that reads the build file of a package in them.
    """
    _SOURCED.workspaces += [folder for folder in folders if folder not in _SOURCED.workspaces]
    _SOURCED.read_source = read_source


def sourced_index(prefixes: Sequence[str] = ()) -> Index:
    """Return an index of the workspaces that were sourced, of `prefixes`, and of the underlay, searched in this order."""
    return Index(prefixes, _SOURCED.workspaces, read_source=_SOURCED.read_source)
