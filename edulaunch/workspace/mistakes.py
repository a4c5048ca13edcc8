"""Common mistakes in packages, each with its place and what to do: what `edulaunch pkg check` shows."""

from __future__ import annotations

import os
from typing import NamedTuple

from edulaunch.packages import Index
from edulaunch.workspace import executables, imports, layout
from edulaunch.workspace.finding import Mistake
from edulaunch.workspace.sources import SourcePackage, source_packages


class Found(NamedTuple):
    """Names of the packages that were looked at, and the mistakes in order of file and line."""

    packages: list[str]
    mistakes: list[Mistake]


def find_mistakes(path: str) -> Found:
    """Look through the workspace or package at `path`. Nothing of it is executed."""
    index = Index((), [path])
    packages = source_packages(index)
    found = [mistake for package in packages for mistake in mistakes_of(index, package)]
    found += layout.of_workspace(os.path.abspath(path), [package.folder for package in packages])
    found += [Mistake(warning.file, warning.line, warning.sentence, None) for warning in index.warnings]
    return Found([package.name for package in packages], sorted(set(found), key=lambda one: (one.file, one.line, one.sentence)))


def mistakes_of(index: Index, package: SourcePackage) -> list[Mistake]:
    """The mistakes of one package."""
    return [*layout.of_package(package), *executables.of_package(package), *imports.of_package(index, package)]
