"""The workspace and the source package that rules over workspaces and sources look at."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index
    from edulaunch.ros.sources.source_package import SourcePackage


class PackageInWorkspace(NamedTuple):
    """One source package, and the index of its workspace."""

    package: SourcePackage
    around: Index

    @property
    def is_readable(self) -> bool:
        """Whether its build file can be read. If not, the installed files are not known."""
        return self.package.contents.broken is None

    @property
    def is_certain(self) -> bool:
        """Whether all files that its build installs are known."""
        return self.is_readable and not self.package.contents.unread

    @property
    def is_of_ros_1(self) -> bool:
        """Whether it is a ROS 1 package, which no ROS 2 workspace builds."""
        return any(warning.about == 'ROS 1' for warning in self.package.contents.warnings)

    @property
    def installed(self) -> dict[str, str]:
        """The real path of each file that is installed unchanged, and its place below the prefix."""
        return {os.path.realpath(path): name for name, path in self.package.contents.files.items()}


class Workspace(NamedTuple):
    """A folder with packages: its absolute path, its index, and its source packages by name."""

    path: str
    around: Index
    packages: list[SourcePackage]

    @property
    def sources(self) -> list[PackageInWorkspace]:
        """Its packages as `PackageInWorkspace` objects."""
        return [PackageInWorkspace(package, self.around) for package in self.packages]


def workspace_at(path: str) -> Workspace:
    """Return the workspace or package folder at `path`."""
    from edulaunch.engine.packages import Index
    from edulaunch.ros.sources import read_source
    from edulaunch.ros.sources.source_package import source_packages

    index = Index((), [path], read_source=read_source)
    return Workspace(os.path.abspath(path), index, source_packages(index))
