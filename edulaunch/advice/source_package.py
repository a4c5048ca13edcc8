"""A package of a workspace with what is around it: what rules over sources look at."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from edulaunch.packages import Index
    from edulaunch.workspace.sources import SourcePackage


class Source(NamedTuple):
    """One source package, and the index of the workspace that it stands in."""

    package: SourcePackage
    around: Index


def packages_at(path: str) -> list[Source]:
    """The source packages of the workspace or package folder at `path`."""
    from edulaunch.packages import Index
    from edulaunch.workspace.sources import source_packages

    index = Index((), [path])
    return [Source(package, index) for package in source_packages(index)]
