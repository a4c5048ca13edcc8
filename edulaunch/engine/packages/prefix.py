"""Install prefixes, as colcon or a package manager creates them, and the prefix of the built-in packages.

Every folder of the underlay's `share/` is a package, and so is every import package of `python/` that ROS has as a package.
Executables are in `share/<package>/console_scripts.txt`, with one `name = module:function` on each line. The modules are in the
underlay's `python/` folder, which is on the ordinary path. Modules in `programs/` sleep, or have threads or an event loop, like
the programs of students. So each process gets its own copy of them, as with modules of a workspace.
"""

from __future__ import annotations

import os
import sys
from functools import cache

from edulaunch.engine.packages.reading import Program

_KINDS = ('msg', 'srv', 'action')


def interface_packages(prefix: str, packages: list[str]) -> list[str]:
    """Return the packages in `packages` whose share folder contains msg/, srv/ or action/."""
    return [
        package for package in packages if any(os.path.isdir(os.path.join(prefix, 'share', package, kind)) for kind in _KINDS)
    ]


MARKERS = os.path.join('share', 'ament_index', 'resource_index', 'packages')


def expand_prefixes(path: str) -> list[str]:
    """Return the prefixes at a path.

    For an isolated colcon `install/`, these are the folders of its packages. For any other path, the only prefix is the path
    itself.
    """
    if os.path.isdir(os.path.join(path, MARKERS)) or not os.path.isdir(path):
        return [path]
    return [
        folder for name in sorted(os.listdir(path)) if os.path.isdir(os.path.join(folder := os.path.join(path, name), MARKERS))
    ] or [path]


class Prefix:
    """A prefix with installed packages."""

    def __init__(self, path: str) -> None:
        self.path = path
        self._packages: list[str] | None = None
        self._entries: dict[str, tuple[str, str]] | None = None

    def packages(self) -> list[str]:
        """Return the names of the packages that have a marker in the resource index."""
        if self._packages is None:
            folder = os.path.join(self.path, MARKERS)
            names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
            self._packages = [name for name in names if not name.startswith('.')]
        return self._packages

    def install(self, package: str) -> None:
        """Do nothing, because the files exist already."""

    def executables(self, package: str) -> list[str]:
        """Return the names of the executable files in `lib/<package>`."""
        folder = os.path.join(self.path, 'lib', package)
        names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
        return [name for name in names if os.path.isfile(file := os.path.join(folder, name)) and os.access(file, os.X_OK)]

    def program(self, package: str, executable: str) -> Program | None:
        """Return an entry point of an installed Python package, or a Python script. Return None for any other file."""
        path = os.path.join(self.path, 'lib', package, executable)
        if not os.path.isfile(path) or not os.access(path, os.X_OK):
            return None
        entry = self._entry_points().get(executable) if _starts_entry_point(path) else None
        if entry is not None:
            return Program('entry_point', package, executable, path, entry[0], entry[1], python_roots=tuple(self._site_folders()))
        if not is_python(path):
            return None
        return Program('script', package, executable, path, file=os.path.realpath(path), python_roots=tuple(self._site_folders()))

    def modules(self) -> dict[str, str]:
        """Return the path of every module in the site-packages of the prefix, by import name."""
        found: dict[str, str] = {}
        for folder in self._site_folders():
            for name in sorted(os.listdir(folder)):
                path = os.path.join(folder, name)
                if name.isidentifier() and os.path.isdir(path):
                    found.setdefault(name, path)
                elif name.endswith('.py') and name[:-3].isidentifier():
                    found.setdefault(name[:-3], path)
        return found

    def interface_packages(self) -> list[str]:
        """Return the packages with interface files in their share folder."""
        return interface_packages(self.path, self.packages())

    def source_path(self, path: str) -> str | None:
        """Return the file behind a link of `colcon build --symlink-install`, or None for a path outside the prefix."""
        return os.path.realpath(path) if path.startswith(self.path + os.sep) else None

    def _site_folders(self) -> list[str]:
        """Return the site-packages folders (dist-packages on Debian) of the prefix.

        The targets of .egg-link files from a symlink install are included.
        """
        found = []
        lib = os.path.join(self.path, 'lib')
        versions = sorted(
            (name for name in (os.listdir(lib) if os.path.isdir(lib) else ()) if name.startswith('python3')),
            key=lambda name: (name != f'python3.{sys.version_info.minor}', name),
        )
        for folder in [os.path.join(lib, name, kind) for name in versions for kind in ('site-packages', 'dist-packages')]:
            if os.path.isdir(folder):
                found += [folder, *_egg_links(folder)]
        return found

    def _entry_points(self) -> dict[str, tuple[str, str]]:
        if self._entries is None:
            names = [(folder, name) for folder in self._site_folders() for name in sorted(os.listdir(folder))]
            found = [os.path.join(*each, 'entry_points.txt') for each in names if each[1].endswith(('.egg-info', '.dist-info'))]
            self._entries = dict(entry for path in found for entry in _console_scripts(path).items())
        return self._entries


def is_python(path: str) -> bool:
    """Return whether a file is a Python file. If the first line begins with `#!`, this line decides. Otherwise, the name of the
    file decides.
    """
    with open(path, 'rb') as stream:
        first = stream.readline(200)
    return first.startswith(b'#!') and b'python' in first or not first.startswith(b'#!') and path.endswith('.py')


def _starts_entry_point(path: str) -> bool:
    """Return whether a file is a script that setuptools generated to call an entry point."""
    with open(path, 'rb') as stream:
        text = stream.read(4000)
    return b'console_scripts' in text or b'EASY-INSTALL' in text


def _egg_links(folder: str) -> list[str]:
    found = []
    for name in sorted(os.listdir(folder)):
        if name.endswith('.egg-link'):
            with open(os.path.join(folder, name), encoding='utf-8') as stream:
                target = stream.readline().strip()
            if os.path.isdir(target):
                found.append(target)
    return found


def _console_scripts(file: str) -> dict[str, tuple[str, str]]:
    """Return (module, function) for each console script of an entry_points.txt, by name."""
    from configparser import ConfigParser

    parser = ConfigParser(delimiters=('=',), interpolation=None)
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    parser.read(file, encoding='utf-8')
    section = parser['console_scripts'] if parser.has_section('console_scripts') else {}
    pairs = {name: target.partition(':') for name, target in section.items()}
    return {name: (module.strip(), function.partition('[')[0].strip()) for name, (module, _, function) in pairs.items()}


_NO_PACKAGES = ('rclcpp_like',)
"""Import packages of edulaunch that ROS does not have."""
_SIGNS = ('package.xml', 'console_scripts.txt', 'interfaces', 'msg', 'srv', 'action')


class Underlay:
    """The prefix that contains the built-in packages."""

    def __init__(self, path: str) -> None:
        self.path = path
        self._modules: dict[str, str] | None = None
        self._scripts: dict[str, dict[str, tuple[str, str]]] = {}

    def packages(self) -> list[str]:
        """Return the names of the built-in packages."""
        return list(_built_in(self.path)[0])

    def install(self, package: str) -> None:
        """Do nothing, because the files exist already."""

    def executables(self, package: str) -> list[str]:
        """Return the names in the package's console_scripts.txt, sorted."""
        return sorted(self._entries(package))

    def program(self, package: str, executable: str) -> Program | None:
        """Return a built-in program, or None if the package does not have this executable."""
        entry = self._entries(package).get(executable)
        if entry is None:
            return None
        path = os.path.join(self.path, 'lib', package, executable)
        own = self.modules().get(entry[0].partition('.')[0])
        roots = () if own is None else (os.path.dirname(own),)
        return Program('entry_point', package, executable, path, entry[0], entry[1], python_roots=roots)

    def modules(self) -> dict[str, str]:
        """Return the path of each module in `programs/`. All other built-in modules are shared, and are on the ordinary path."""
        if self._modules is None:
            folder = os.path.join(self.path, 'programs')
            names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
            self._modules = {name: os.path.join(folder, name) for name in names}
        return self._modules

    def interface_packages(self) -> list[str]:
        """Return the built-in packages with interface files in their share folder."""
        return list(_built_in(self.path)[1])

    def source_path(self, path: str) -> str | None:
        """Return None, because built-in files are not links."""
        return None

    def _entries(self, package: str) -> dict[str, tuple[str, str]]:
        entries = self._scripts.get(package)
        if entries is None:
            try:
                with open(os.path.join(self.path, 'share', package, 'console_scripts.txt'), encoding='utf-8') as stream:
                    lines = [line.partition('#')[0] for line in stream]
            except (FileNotFoundError, NotADirectoryError):
                lines = []  # a package without executables; any other error is a fault of this computer
            entries = self._scripts[package] = {}
            for line in filter(str.strip, lines):
                name, _, target = line.partition('=')
                module, _, function = target.strip().partition(':')
                entries[name.strip()] = (module.strip(), function.strip())
        return entries


@cache
def _built_in(path: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the packages of an underlay, and the packages with interface files.

    The underlay is searched only once, because it does not change while edulaunch runs. This search of 350 files would take a
    third of the time of a short run.
    """
    share = os.path.join(path, 'share')
    names = sorted(os.listdir(share)) if os.path.isdir(share) else []
    shared = [name for name in names if any(os.path.exists(os.path.join(share, name, sign)) for sign in _SIGNS)]
    packages = sorted({*shared, *_faces(os.path.join(path, 'python'))})
    return tuple(packages), tuple(interface_packages(path, packages))


def _faces(python: str) -> list[str]:
    """Return the names of the import packages that are also ROS packages."""
    names = os.listdir(python) if os.path.isdir(python) else []
    return [name for name in names if name not in _NO_PACKAGES and os.path.isfile(os.path.join(python, name, '__init__.py'))]
