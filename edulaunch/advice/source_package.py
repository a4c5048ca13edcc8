"""The objects that rules for workspaces and rules for source packages check."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index
    from edulaunch.ros.sources.source_package import SourcePackage


class PackageInWorkspace(NamedTuple):
    """One source package, and the index of the workspace that contains it."""

    package: SourcePackage
    around: Index

    @property
    def is_readable(self) -> bool:
        """Whether the build file of the package can be read. If not, the installed files are unknown."""
        return self.package.contents.broken is None

    @property
    def is_certain(self) -> bool:
        """Whether all files are known that a build of the package installs."""
        return self.is_readable and not self.package.contents.unread

    @property
    def is_of_ros_1(self) -> bool:
        """Whether the package is a ROS 1 package, which a ROS 2 workspace cannot build."""
        return any(warning.about == 'ROS 1' for warning in self.package.contents.warnings)

    @property
    def installed(self) -> dict[str, str]:
        """The path below the prefix of each file that a build installs unchanged, by its real path in the sources."""
        return {os.path.realpath(path): name for name, path in self.package.contents.files.items()}


class Workspace(NamedTuple):
    """A folder with packages: its absolute path, its index, and its source packages."""

    path: str
    around: Index
    packages: list[SourcePackage]

    @property
    def sources(self) -> list[PackageInWorkspace]:
        """The packages of the workspace as `PackageInWorkspace` objects."""
        return [PackageInWorkspace(package, self.around) for package in self.packages]


def workspace_at(path: str) -> Workspace:
    """Read the workspace or package folder at `path`, and return it."""
    from edulaunch.engine.packages import Index
    from edulaunch.ros.sources import read_source
    from edulaunch.ros.sources.source_package import source_packages

    index = Index((), [path], read_source=read_source)
    return Workspace(os.path.abspath(path), index, source_packages(index))
