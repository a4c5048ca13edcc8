"""A submission that is a whole ROS 2 package: where it begins, what it is called, what is in it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import NamedTuple

MANIFEST = 'package.xml'
DEEPEST = 5  # folders between a launch file and its package.xml
_NAME = re.compile(r'<name>\s*([A-Za-z][\w-]*)\s*</name>')
_TEXTS = ('.py', '.xml', '.yaml', '.yml', '.cfg', '.toml', '.txt', '.msg', '.srv', '.action', '.rviz', '.urdf')
_GENERATED = ('build', 'install', 'log', '__pycache__')
LARGEST_BYTES = 1_000_000
MOST_FILES = 400


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
        """(path relative to the package, content) of its text files, in a fixed order; the first MOST_FILES of them."""
        found = 0
        for folder, folders, names in os.walk(self.path):
            folders[:] = sorted(name for name in folders if name not in _GENERATED and not name.startswith('.'))
            for name in sorted(names):
                if name.endswith(_TEXTS) and found < MOST_FILES:
                    found += 1
                    path = os.path.join(folder, name)
                    with open(path, 'rb') as file:
                        yield os.path.relpath(path, self.path), file.read(LARGEST_BYTES)


def package_at(folder: str) -> PackageFolder | None:
    """The package whose package.xml is in this folder, if there is one."""
    try:
        with open(os.path.join(folder, MANIFEST), encoding='utf-8', errors='replace') as file:
            match = _NAME.search(file.read(LARGEST_BYTES))
    except OSError:
        return None
    path = os.path.abspath(folder)
    return PackageFolder(path, match[1] if match else os.path.basename(path))


def package_above(file: str) -> PackageFolder | None:
    """The package that a file belongs to, if it lies in one."""
    folder = os.path.dirname(os.path.abspath(file))
    for _ in range(DEEPEST):
        package = package_at(folder)
        if package is not None or os.path.dirname(folder) == folder:
            return package
        folder = os.path.dirname(folder)
    return None
