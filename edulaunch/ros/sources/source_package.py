"""The packages of a workspace in the form that checks use: manifest, contents, sources, and modules. The file also
determines the folders from which a build installs data files. No module of a package is imported.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator
from fnmatch import fnmatch
from functools import cached_property
from typing import NamedTuple
from xml.etree import ElementTree

from edulaunch.engine.packages import Index
from edulaunch.engine.packages.reading import Contents, read_manifest

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
    """One dependency in a package.xml. The attribute `line` counts from 1."""

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
        """Whether the package is built with setup.py, or would be built with it if the file were not missing."""
        manifest = read_manifest(self.folder, [])
        if os.path.isfile(self.build_file('CMakeLists.txt')):
            return manifest is not None and manifest.build_type == 'ament_python'  # colcon then does not read CMakeLists.txt
        return os.path.isfile(self.build_file('setup.py')) or (manifest is not None and manifest.build_type == 'ament_python')

    def build_file(self, name: str | None = None) -> str:
        """The path of setup.py or CMakeLists.txt."""
        return os.path.join(self.folder, name or ('setup.py' if self.is_python else 'CMakeLists.txt'))

    @cached_property
    def dependencies(self) -> list[Dependency]:
        """The dependencies in package.xml, including those under a condition, in the order of its tags."""
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
        """The paths of all Python files of the package except tests and setup.py, sorted."""
        return sorted(
            path
            for path in self.files()
            if path.endswith('.py') and os.path.relpath(path, self.folder).split(os.sep)[0] not in ('test', 'tests', 'setup.py')
        )

    def files(self) -> Iterator[str]:
        """Yield all files except those in hidden folders, hidden files, and files that Python and colcon generate."""
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
        """Return a path relative to the package's folder."""
        return os.path.relpath(path, self.folder)

    def is_test(self, path: str) -> bool:
        """Return whether a file is in a folder of tests, or has the name of a test file."""
        *folders, name = self.relative(path).split(os.sep)
        words = name.partition('.')[0].split('_')
        return not {'test', 'tests'}.isdisjoint(folders) or 'tester' in words or 'test' in (words[0], words[-1])

    def is_launch_file(self, path: str) -> bool:
        """Return whether a file is a launch file, by its name or its folder. The description of a launch test does not count,
        because pytest and launch_test read it in place.
        """
        name = os.path.basename(path)
        if self.is_test(path) or name.endswith('.launch') and _OF_ROS_1.search(read_text(path)):
            return False
        if name.endswith('.py') and 'generate_test_description' in read_text(path):
            return False
        if name == 'launch.py' and 'LaunchDescription' not in read_text(path):
            return False  # it is a module with this name
        if name.endswith(('launch.py', 'launch.xml', 'launch.yaml', 'launch.yml', '.launch')):
            return True
        return (
            os.path.basename(os.path.dirname(path)) == 'launch'
            and name.endswith('.py')
            and not name.startswith('__')
            and 'generate_launch_description' in read_text(path)
        )


_OF_ROS_1 = re.compile(r'\$\(find |<node[^>]*\btype\s*=')
"""Signs that occur only in a launch file of ROS 1."""


def source_packages(index: Index) -> list[SourcePackage]:
    """Return the packages in the source workspaces of an index, by package name."""
    return [
        SourcePackage(name, place.package_folder(name), place.contents(name))
        for place in index.workspaces
        for name in place.packages()
    ]


def read_text(path: str) -> str:
    """Return the text of a file, or '' if the file cannot be read."""
    try:
        with open(path, encoding='utf-8', errors='replace') as file:
            return file.read()
    except OSError:
        return ''


def parsed(path: str) -> ast.Module | None:
    """Return the syntax tree of a Python file, or None if the file is not valid Python."""
    try:
        with open(path, 'rb') as file:
            return ast.parse(file.read(), path)
    except (OSError, SyntaxError, ValueError):
        return None


def _line_of(lines: list[str], tag: str, name: str) -> int:
    """Return the line of a dependency, or 0 if it is not written on a single line."""
    for number, line in enumerate(lines, 1):
        if f'<{tag}' in line and name in line.replace('<', ' ').replace('>', ' ').split():
            return number
    return 0


def module_file(package: SourcePackage, module: str) -> str | None:
    """Return the file of a module that the package installs, or None if there is no such file."""
    top, _, rest = module.partition('.')
    place = package.contents.python_modules.get(top)
    if place is None:
        return None
    base = os.path.join(place, *rest.split('.')) if rest else place
    return next((path for path in (f'{base}.py', os.path.join(base, '__init__.py'), base) if os.path.isfile(path)), None)


def modules_of(package: SourcePackage) -> dict[str, str]:
    """Return the full names of the package's installed modules, with their files."""
    found = {}
    for top, place in package.contents.python_modules.items():
        for path in package.python_files:
            if path.startswith(place + os.sep):
                name = os.path.relpath(path, os.path.dirname(place))[:-3].replace(os.sep, '.')
                found[name.removesuffix('.__init__')] = path
        if os.path.isfile(place):
            found[top] = place
    return found


def defined_names(tree: ast.Module) -> list[str]:
    """Return the names that a module defines or imports at its top level, including those under `if` and `try`."""
    names = []
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            names.append(node.name)
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            names += [alias.asname or alias.name for alias in node.names]
        elif isinstance(node, ast.Assign):
            names += [target.id for target in node.targets if isinstance(target, ast.Name)]
    return names


def main_of(tree: ast.Module, name: str) -> ast.FunctionDef | None:
    """Return the top-level function with that name, or None if there is no such function."""
    return next((node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == name), None)


def line_with(file: str, word: str) -> int:
    """Return the number of the first line that contains the word, or 0 if no line does."""
    return next((number for number, line in enumerate(read_text(file).splitlines(), 1) if word in line), 0)


LAUNCH_PATTERN = '*launch.[pxy][yma]*'
DATA_FOLDERS = ('config', 'params', 'param', 'rviz', 'urdf', 'worlds', 'maps', 'meshes')


def install_facts(package: SourcePackage, path: str) -> dict[str, str | None]:
    """Return facts about how to install a data file.

    :returns: a dict. `beside` is the folder whose files are already installed. For a file beside the build file, `move` is the
        folder in which it belongs. `folder` and `pattern` are for setup.py, and `top` is for CMakeLists.txt. A fact that does not
        apply has the value None.
    """
    folder, name = os.path.split(package.relative(path))
    place = folder or ('launch' if package.is_launch_file(path) else 'config')
    ending = os.path.splitext(name)[1]
    is_beside = not folder and any(f'/{place}/' in target and target.endswith(ending) for target in package.contents.files)
    return {
        'beside': place if is_beside else None,
        'move': None if folder else place,
        'folder': place,
        'pattern': os.path.join(place, _pattern(package, path, name)) if package.is_python else None,
        'top': place.split(os.sep)[0],
    }


def _pattern(package: SourcePackage, path: str, name: str) -> str:
    """Return a glob() pattern that matches the file: the pattern of ROS 2's tutorials for launch files, if it matches."""
    if not package.is_launch_file(path):
        return '*'
    return LAUNCH_PATTERN if fnmatch(name, LAUNCH_PATTERN) else '*' + os.path.splitext(name)[1]
