"""What reading a source package gives: things to install, and what could not be understood."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class PackageWarning:
    """Something in a package that a build would reject, or that cannot be known without running it.

    `line` counts from 1; 0 means the file as a whole.
    """

    file: str
    line: int
    sentence: str

    def __str__(self) -> str:
        place = f'{self.file}:{self.line}' if self.line else self.file
        return f'{place}: {self.sentence}'


@dataclass
class Contents:
    """What a package installs, as its build file says.

    :param files: path below the prefix -> absolute path of the source file.
    :param entry_points: path below the prefix (`lib/<package>/<executable>`) -> (module, function).
    :param programs: those of `files` that are installed as executables.
    :param python_modules: top-level import name -> absolute path of its folder or .py file.
    :param native: executables built from C++ or C: name -> line of the build file; they cannot run here.
    :param interfaces: there are .msg, .srv or .action files among `files`.
    """

    files: dict[str, str] = field(default_factory=dict)
    entry_points: dict[str, tuple[str, str]] = field(default_factory=dict)
    programs: set[str] = field(default_factory=set)
    python_modules: dict[str, str] = field(default_factory=dict)
    native: dict[str, int] = field(default_factory=dict)
    interfaces: bool = False
    warnings: list[PackageWarning] = field(default_factory=list)
