"""The index that belongs to a program's AMENT_PREFIX_PATH."""

from __future__ import annotations

import os

from edulaunch.engine.packages import Index
from edulaunch.engine.processes import current_process
from edulaunch.engine.underlay_place import underlay_prefix

from .constants import AMENT_PREFIX_PATH_ENV_VAR


def own_path() -> str | None:
    """Return the running program's AMENT_PREFIX_PATH, or None if the program has not changed it since the workspace was
    sourced.
    """
    process = current_process()
    path = process.env.get(AMENT_PREFIX_PATH_ENV_VAR, '')
    return None if path == process.sourced_path else path


def index_in_force() -> Index:
    """Return the simulation's index. If the program has changed AMENT_PREFIX_PATH, return an index of only the prefixes in it."""
    path, sourced = own_path(), current_process().index
    return sourced if path is None else _index_of(path, sourced)


def existing(path: str) -> list[str]:
    """Return the existing folders of a path list such as AMENT_PREFIX_PATH."""
    return [folder for folder in path.split(os.pathsep) if folder and os.path.exists(folder)]


def _index_of(path: str, sourced: Index) -> Index:
    """Return the index of the prefixes in `path`. It contains built-in packages and workspaces only if `path` names them."""
    underlay, named = underlay_prefix(), path.split(os.pathsep)
    folders = [workspace.folder for workspace in sourced.workspaces if workspace.path in named]
    generated = {workspace.path for workspace in sourced.workspaces}
    prefixes = [prefix for prefix in existing(path) if prefix not in generated]
    return Index(prefixes, folders, read_source=sourced.read_source, underlay=underlay if underlay in named else None)
