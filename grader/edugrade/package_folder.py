"""A submission that is a whole ROS 2 package: where it begins, what it is called, what is in it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import suppress
from typing import NamedTuple

from .regular_file import read_regular

MANIFEST = 'package.xml'
DEEPEST = 5  # folders between a launch file and its package.xml
_NAME = re.compile(r'<name>\s*([A-Za-z][\w-]*)\s*</name>')
_TEXTS = ('.py', '.xml', '.yaml', '.yml', '.cfg', '.toml', '.txt', '.msg', '.srv', '.action', '.rviz', '.urdf')
_GENERATED = ('build', 'install', 'log', '__pycache__')
LARGEST_BYTES = 1_000_000
MOST_FILES = 400
MOST_FOLDERS = 4000
DEEPEST_TEXT = 30  # folders below the package's


class PackageFolder(NamedTuple):
    """The folder of a package (absolute), and the package's name."""

    path: str
    name: str

    @property
    def workspace(self) -> str:
        """What to search for packages: the colcon workspace when this lies in its ``src``, else the package itself."""
        parent = os.path.dirname(self.path)
        while os.path.dirname(parent) != parent:
            if os.path.basename(parent) == 'src':
                return os.path.dirname(parent)
            parent = os.path.dirname(parent)
        return self.path

    @property
    def launch_file(self) -> str:
        """The file that launches everything: named after the package, in its folder ``launch``."""
        return os.path.join(self.path, 'launch', f'{self.name}.launch.py')

    def texts(self) -> Iterator[tuple[str, bytes]]:
        """(path relative to the package, content) of its text files, in a fixed order; the first MOST_FILES of them.

        Links, pipes, what cannot be read and what lies deeper than DEEPEST_TEXT folders is left out.
        """
        found = 0
        for path in self._files():
            if found == MOST_FILES:
                return
            with suppress(OSError):
                yield os.path.relpath(path, self.path), read_regular(path, LARGEST_BYTES)
                found += 1

    def _files(self) -> Iterator[str]:
        pending = [(self.path, 0)]
        for _ in range(MOST_FOLDERS):
            if not pending:
                return
            folder, depth = pending.pop()
            with suppress(OSError), os.scandir(folder) as entries:
                found = sorted((entry for entry in entries if not entry.is_symlink()), key=lambda entry: entry.name)
                yield from (entry.path for entry in found if entry.name.endswith(_TEXTS) and not entry.is_dir())
                inside = [entry for entry in found if entry.is_dir() and depth < DEEPEST_TEXT and not _is_generated(entry.name)]
                pending += [(entry.path, depth + 1) for entry in reversed(inside)]


def package_at(folder: str) -> PackageFolder | None:
    """The package whose package.xml is in this folder, if there is one."""
    try:
        match = _NAME.search(read_regular(os.path.join(folder, MANIFEST), LARGEST_BYTES).decode('utf-8', 'replace'))
    except OSError:
        return None
    path = os.path.abspath(folder)
    return PackageFolder(path, match[1] if match else os.path.basename(path))


def _is_generated(name: str) -> bool:
    return name in _GENERATED or name.startswith('.')


def package_above(file: str) -> PackageFolder | None:
    """The package that a file belongs to, if it lies in one."""
    folder = os.path.dirname(os.path.abspath(file))
    for _ in range(DEEPEST):
        package = package_at(folder)
        if package is not None or os.path.dirname(folder) == folder:
            return package
        folder = os.path.dirname(folder)
    return None
