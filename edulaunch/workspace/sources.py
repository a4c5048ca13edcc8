"""The packages of a workspace as the checks see them: manifest, contents and sources."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple
from xml.etree import ElementTree

from edulaunch.packages import Index
from edulaunch.packages.manifest import read_manifest
from edulaunch.packages.reading import Contents

DEPENDENCY_TAGS = (
    'depend',
    'build_depend',
    'build_export_depend',
    'buildtool_depend',
    'buildtool_export_depend',
    'exec_depend',
    'run_depend',
    'test_depend',
)
RUNTIME_TAGS = ('depend', 'exec_depend', 'run_depend')


class Dependency(NamedTuple):
    """One dependency of a package.xml; `line` counts from 1."""

    name: str
    tag: str
    line: int


class SourcePackage:
    """One package of a source workspace."""

    def __init__(self, name: str, folder: str, contents: Contents) -> None:
        self.name = name
        self.folder = folder
        self.contents = contents
        self.manifest_file = os.path.join(folder, 'package.xml')

    @property
    def is_python(self) -> bool:
        """Whether it is built by setup.py, or would be: it may have been forgotten."""
        if os.path.isfile(self.build_file('CMakeLists.txt')):
            return False
        manifest = read_manifest(self.folder, [])
        return os.path.isfile(self.build_file('setup.py')) or (manifest is not None and manifest.build_type == 'ament_python')

    def build_file(self, name: str | None = None) -> str:
        """setup.py or CMakeLists.txt."""
        return os.path.join(self.folder, name or ('setup.py' if self.is_python else 'CMakeLists.txt'))

    @cached_property
    def dependencies(self) -> list[Dependency]:
        """What package.xml names, in the order of its tags; those under a condition too."""
        with open(self.manifest_file, encoding='utf-8', errors='replace') as file:
            lines = file.read().splitlines()
        root = ElementTree.fromstring('\n'.join(lines).encode('utf-8'))
        found = []
        for tag in DEPENDENCY_TAGS:
            for element in root.iter(tag):
                name = (element.text or '').strip()
                if name:
                    found.append(Dependency(name, tag, _line_of(lines, tag, name)))
        return found

    @cached_property
    def python_files(self) -> list[str]:
        """All Python files of the package but tests and setup.py, sorted."""
        return sorted(
            path
            for path in self.files()
            if path.endswith('.py') and os.path.relpath(path, self.folder).split(os.sep)[0] not in ('test', 'tests', 'setup.py')
        )

    def files(self) -> Iterator[str]:
        """All files, without hidden folders and what Python and colcon generate."""
        for folder, folders, names in os.walk(self.folder):
            folders[:] = sorted(
                name
                for name in folders
                if not name.startswith('.')
                and name not in ('__pycache__', 'build', 'install', 'log')
                and not name.endswith('.egg-info')
            )
            yield from (os.path.join(folder, name) for name in sorted(names))

    def relative(self, path: str) -> str:
        """A path below the package's folder."""
        return os.path.relpath(path, self.folder)

    def is_launch_file(self, path: str) -> bool:
        """Whether this is a launch file: by its name, or by its folder. The description of a launch test is none: pytest and
        launch_test read it where it lies.
        """
        name = os.path.basename(path)
        is_in_tests = self.relative(path).split(os.sep)[0] in ('test', 'tests')
        if is_in_tests or name.endswith('.py') and 'generate_test_description' in read_text(path):
            return False
        if name.endswith(('launch.py', 'launch.xml', 'launch.yaml', 'launch.yml', '.launch')):
            return True
        return (
            os.path.basename(os.path.dirname(path)) == 'launch'
            and name.endswith('.py')
            and not name.startswith('__')
            and 'generate_launch_description' in read_text(path)
        )


def source_packages(index: Index) -> list[SourcePackage]:
    """The packages of an index's source workspaces, by name."""
    return [
        SourcePackage(name, place.package_folder(name), place.contents(name))
        for place in index.workspaces
        for name in place.packages()
    ]


def read_text(path: str) -> str:
    """The text of a file; empty when it cannot be read."""
    try:
        with open(path, encoding='utf-8', errors='replace') as file:
            return file.read()
    except OSError:
        return ''


def parsed(path: str) -> ast.Module | None:
    """The syntax tree of a Python file, None when it is no Python."""
    try:
        with open(path, 'rb') as file:
            return ast.parse(file.read(), path)
    except (OSError, SyntaxError, ValueError):
        return None


def _line_of(lines: list[str], tag: str, name: str) -> int:
    """The line of a dependency; 0 when it is written in some other way than on one line."""
    for number, line in enumerate(lines, 1):
        if f'<{tag}' in line and name in line.replace('<', ' ').replace('>', ' ').split():
            return number
    return 0
