"""What reading a source package gives: things to install, and what could not be understood."""

from __future__ import annotations

from typing import NamedTuple


class PackageWarning(NamedTuple):
    """Something in a package that a build would reject, or that cannot be known without running it.

    `line` counts from 1; 0 means the file as a whole.
    """

    file: str
    line: int
    sentence: str

    def __str__(self) -> str:
        place = f'{self.file}:{self.line}' if self.line else self.file
        return f'{place}: {self.sentence}'


class Contents:
    """What a package installs, as its build file says.

    :param files: path below the prefix -> absolute path of the source file.
    :param entry_points: path below the prefix (`lib/<package>/<executable>`) -> (module, function).
    :param programs: those of `files` that are installed as executables.
    :param python_modules: top-level import name -> absolute path of its folder or .py file.
    :param native: executables built from C++ or C: name -> line of the build file; they cannot run here.
    :param announced: group of entry points -> lines `name = package.module:attribute`.
    :param version: what setup() says, '' when it says nothing.
    :param broken: why a build stops before anything is installed; it stands in `warnings`, too.
    :param interfaces: there are .msg, .srv or .action files among `files`.
    """

    def __init__(self) -> None:
        self.files: dict[str, str] = {}
        self.entry_points: dict[str, tuple[str, str]] = {}
        self.programs: set[str] = set()
        self.python_modules: dict[str, str] = {}
        self.native: dict[str, int] = {}
        self.broken: PackageWarning | None = None
        self.interfaces = False
        self.warnings: list[PackageWarning] = []
