"""Puts the underlay and workspaces on the path, as ROS 2's setup files do."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib.machinery import PathFinder
from typing import TYPE_CHECKING

from edulaunch.engine.underlay_place import underlay_prefix, underlay_python
from edulaunch.errors import ForeignRosError

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index


_INDEXES: list[Index] = []
"""The indexes of the sourced workspaces. Their generated prefixes exist as long as these objects."""


def source(workspaces: Sequence[str | os.PathLike[str]] = ()) -> None:
    """Make `launch`, `rclpy`, `tf2_ros`, `geometry_msgs` and the other ROS packages importable. A second call has no effect.

    :param workspaces: folders with packages, built by colcon or not. Afterwards, their modules, interfaces and programs are
        available, as after `source install/setup.bash`. A workspace with changed files is sourced again.
    :raises ForeignRosError: when a different `rclpy` can already be imported. In this case, nothing changes.
    """
    from edulaunch.engine.interfaces.importer import installed_registry

    place = underlay_python()
    if place not in sys.path or installed_registry() is None:
        foreign = _foreign_rclpy(place)
        if foreign is not None:
            raise ForeignRosError(
                f'a ROS 2 installation is on the Python path: rclpy at {foreign}. edulaunch does not shadow it.',
                help='open a terminal in which ROS 2 is not sourced (check: printenv PYTHONPATH), or a fresh virtual environment',
            )
        from edulaunch.engine.interfaces import install

        if place not in sys.path:
            sys.path.insert(0, place)
        install()
        from edulaunch.engine.packages.sourced import put_on_prefix_path

        put_on_prefix_path()
    if workspaces:
        _source_workspaces(workspaces)


def _source_workspaces(workspaces: Sequence[str | os.PathLike[str]]) -> None:
    from edulaunch.engine.interfaces import install
    from edulaunch.engine.packages.discovery import install_folders
    from edulaunch.engine.packages.index import interfaces_of
    from edulaunch.engine.packages.sourced import add_workspaces, put_on_prefix_path, sourced_index
    from edulaunch.ros.sources import read_source

    built, sources = install_folders(workspaces)
    add_workspaces(sources, read_source)
    index = sourced_index(built)
    _INDEXES[:] = [index]
    for package in index.packages():
        index.prefix(package)
    roots = [path for path in index.python_roots() if path not in sys.path]
    position = sys.path.index(underlay_python())
    sys.path[position:position] = roots
    own, registry = interfaces_of(index)
    if own:
        install(registry)
    put_on_prefix_path([path for path in index.search_paths() if path != underlay_prefix()])


def _foreign_rclpy(ours: str) -> str | None:
    """Return the folder of a foreign rclpy, or None."""
    loaded = sys.modules.get('rclpy')
    spec = PathFinder.find_spec('rclpy') if loaded is None else loaded.__spec__
    if spec is None or spec.origin is None or spec.origin.startswith(ours + os.sep):
        return None
    return os.path.dirname(spec.origin)
