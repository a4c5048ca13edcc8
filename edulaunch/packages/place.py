"""What the index asks of each place it searches."""

from __future__ import annotations

from typing import Protocol

from edulaunch.packages.program import Program


class Place(Protocol):
    """A prefix, or something presented as one.

    :attr:`path` is the prefix folder; all methods take names of packages that :meth:`packages` lists.
    """

    path: str

    def packages(self) -> list[str]:
        """Names of the packages here, sorted."""

    def install(self, package: str) -> None:
        """Make sure that the package's files stand below :attr:`path`."""

    def executables(self, package: str) -> list[str]:
        """Names in lib/<package> that can be started, sorted."""

    def program(self, package: str, executable: str) -> Program | None:
        """The Python program of that name; None when there is none, or when it is not Python."""

    def modules(self) -> dict[str, str]:
        """Top-level import names that packages here bring, with the path of each folder or .py file."""

    def interface_packages(self) -> list[str]:
        """Packages with msg/, srv/ or action/ files in their share folder, sorted."""

    def source_path(self, path: str) -> str | None:
        """The file as the student wrote it, for a path below :attr:`path`."""
