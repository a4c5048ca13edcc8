"""The packages that a file can use: the packages of its workspace, and the built-in packages."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from edulaunch.engine.nearest import nearest_spelling
from edulaunch.engine.packages import Index
from edulaunch.engine.packages.discovery import find_workspaces, install_folders
from edulaunch.engine.packages.index import interfaces_of

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index


class Around:
    """The packages that launch would find for a file. Each object reads the packages once.

    :param path: the path of the file.
    :param workspaces: folders with packages (default: the folders that a command in the folder of the file would find).
    :param env: the environment variables that determine these folders.
    """

    def __init__(self, path: str, workspaces: Sequence[str] = (), env: Mapping[str, str] | None = None) -> None:
        self.path = os.path.abspath(path)
        self._env = dict(os.environ if env is None else env)
        self._workspaces = list(workspaces)
        self._executables: dict[str, list[str]] = {}

    @cached_property
    def workspaces(self) -> list[str]:
        """The folders that contain the packages."""
        return self._workspaces or find_workspaces(os.path.dirname(self.path), self._env, self.path)

    @cached_property
    def index(self) -> Index:
        """The index of the packages."""
        from edulaunch.ros.sources import read_source

        built, sources = install_folders(self.workspaces)
        return Index(built, sources, read_source=read_source)

    @cached_property
    def registry(self) -> Any:
        """The registry of the messages, services and actions of all packages."""
        return interfaces_of(self.index)[1]

    @cached_property
    def packages(self) -> list[str]:
        """The names of all packages."""
        return list(self.index.packages())

    def executables(self, package: str) -> list[str]:
        """Return the names of the executables of a package."""
        if package not in self._executables:
            known = [*self.index.executables(package), *self.index.native_executables(package)]
            self._executables[package] = sorted(set(known))
        return self._executables[package]

    def launch_files(self, package: str) -> dict[str, str]:
        """Return a dict from the name of each installed launch file to its path relative to the share folder."""
        share = self.index.share(package) if package in self.packages else None
        found: dict[str, str] = {}
        for folder, folders, names in os.walk(share or '', followlinks=True) if share else ():
            folders.sort()
            for name in sorted(names):
                if name.endswith(('launch.py', 'launch.xml', 'launch.yaml', 'launch.yml')):
                    found.setdefault(name, os.path.relpath(os.path.join(folder, name), share))
        return found

    def unknown_package(self, package: str) -> dict[str, Any] | None:
        """Return facts about a misspelt package. Return None if the package exists, or may exist elsewhere."""
        if package in self.packages or self.index.absent(package) is not None:
            return None
        near = nearest_spelling(package, self.packages)
        return {'about': 'packages.unknown', 'package': package, 'near': near, 'searched': self.workspaces} if near else None

    def unknown_executable(self, package: str, executable: str) -> dict[str, Any] | None:
        """Return facts about an executable that a package does not contain.

        Return None if the package contains it, or if the executables of the package are unknown.
        """
        from edulaunch.ros.sources.missing import missing_executable

        if package not in self.packages or executable in self.executables(package) or not self.executables(package):
            return None
        return missing_executable(self.index, package, executable)
