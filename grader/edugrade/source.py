"""Finds places in files of a submission. Places only help readers to find a line, and never affect marks."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from typing import NamedTuple

from edulaunch.engine.underlay_place import engine_folder


class Place(NamedTuple):
    """A file, and a line (counted from 1) if it is known."""

    file: str
    line: int | None = None

    def __str__(self) -> str:
        return f'{self.file}:{self.line}' if self.line else self.file


def is_engine(file: str) -> bool:
    """Return whether a file is code of edulaunch itself, and not one of its launch files."""
    return is_shipped(file) and not file.startswith(os.path.join(engine_folder(), 'ros', 'share'))


def is_shipped(file: str) -> bool:
    """Return whether a file is part of edulaunch. Students cannot change such a file."""
    return file.startswith(engine_folder() + os.sep)


def shipped_program(package: str, executable: str) -> str:
    """Return the path under which edulaunch runs a program of a built-in package."""
    return os.path.join(engine_folder(), 'ros', 'lib', package, executable)


def comes_with_edulaunch(package: str) -> bool:
    """Return whether edulaunch contains a package with this name."""
    return os.path.isdir(os.path.join(engine_folder(), 'ros', 'share', package))


_GAP = re.compile(r'\s*(?:#|<!--)\s*TODO\b\s*(\d{0,9})')
_FUNCTION = re.compile(r'\s*(async\s+)?def\s+generate_launch_description\b')
_LIST = re.compile(r'.*\bLaunchDescription\s*\(')
_ROOT = re.compile(r'\s*<launch\b|launch\s*:')  # of a launch file in XML or YAML


class Gap(NamedTuple):
    """A comment that marks a missing part of a file."""

    file: str
    line: int
    text: str


class SubmittedText:
    """The lines of a submission.

    :param file: the absolute path of the launch file.
    :param text: the content of the launch file.
    :param others: the content of the other files of a package, by absolute path.
    """

    def __init__(self, file: str, text: str, others: Mapping[str, str] | None = None) -> None:
        self.file = file
        self._lines = text.splitlines()
        self._others = {path: other.splitlines() for path, other in (others or {}).items() if path != file}

    @property
    def place(self) -> Place:
        """The place for a missing action: the line of ``LaunchDescription(``, or else the line of the function or of the root
        element.
        """
        function = _line_of(_FUNCTION, self._lines) or _line_of(_ROOT, self._lines)
        return Place(self.file, _line_of(_LIST, self._lines, function or 0) or function)

    def place_in(self, name: str, pattern: str = '') -> Place:
        """Return a place in a file of the package: the first line in which `pattern` matches.

        :param name: the end of the file's path, such as ``config/turtlesim.yaml``. Without such a file, return :attr:`place`.
        """
        for path, lines in {self.file: self._lines, **self._others}.items():
            if path.endswith(os.sep + name.replace('/', os.sep)):
                return Place(path, _line_of(re.compile(f'.*(?:{pattern})'), lines) if pattern else None)
        return self.place

    def own(self, origin: tuple[str, int | None] | None, pattern: str = '') -> Place:
        """Return a place that the student can change.

        The place is `origin` if `origin` is in the student's files, or else the line in which `pattern` matches, or else
        :attr:`place`.
        """
        if origin is not None and not is_shipped(origin[0]):
            return Place(*origin)
        line = _line_of(re.compile(f'.*(?:{pattern})'), self._lines) if pattern else None
        return self.place if line is None else Place(self.file, line)

    def texts(self) -> dict[str, str]:
        """Return the content of all files, by their paths relative to their common folder."""
        known = {self.file: self._lines, **self._others}
        above = os.path.commonpath([os.path.dirname(path) for path in known])
        return {os.path.relpath(path, above): '\n'.join(lines) for path, lines in known.items()}

    def bodies(self) -> dict[str, list[str]]:
        """Return the lines of each file from the function with the launch description on, by the file's name.

        Students write in these lines. A file without such a function is returned completely.
        """
        found = {}
        for path, lines in {self.file: self._lines, **self._others}.items():
            start = _line_of(_FUNCTION, lines) or 1
            found[os.path.basename(path)] = lines[start - 1 :]
        return found

    @property
    def gaps(self) -> list[Gap]:
        """The comments that mark missing parts, in the order of the numbers after TODO."""
        found = []
        for path, lines in {self.file: self._lines, **self._others}.items():
            for number, line in enumerate(lines, 1):
                match = _GAP.match(line)
                if match:
                    found.append((int(match[1] or 0), Gap(path, number, line.strip())))
        return [gap for _, gap in sorted(found, key=lambda item: item[0])]


def _line_of(pattern: re.Pattern[str], lines: list[str], after: int = 0) -> int | None:
    for number, line in enumerate(lines, 1):
        if number >= after and pattern.match(line):
            return number
    return None
