"""The built-in packages, laid out like a prefix.

Every folder of `share/` is a package, and so is every import package of `python/` that ROS has as a package.
Executables stand in `share/<package>/console_scripts.txt`, one `name = module:function` on a line. The modules lie in the
underlay's `python/` folder, on the ordinary path; or in `programs/`, when they are written as students write theirs (they sleep,
have threads or an event loop), so that each process gets modules of its own, as those of a workspace.
"""

from __future__ import annotations

import os

from edulaunch.packages.program import Program
from edulaunch.packages.share import interface_packages

_NO_PACKAGES = ('rclcpp_like',)
"""Import packages of ours that ROS does not have."""
_SIGNS = ('package.xml', 'console_scripts.txt', 'interfaces', 'msg', 'srv', 'action')


class Underlay:
    """One underlay prefix."""

    def __init__(self, path: str) -> None:
        self.path = path
        self._packages: list[str] | None = None
        self._modules: dict[str, str] | None = None
        self._scripts: dict[str, dict[str, tuple[str, str]]] = {}

    def packages(self) -> list[str]:
        """Names of the built-in packages."""
        if self._packages is None:
            share = os.path.join(self.path, 'share')
            names = sorted(os.listdir(share)) if os.path.isdir(share) else []
            shared = [name for name in names if any(os.path.exists(os.path.join(share, name, sign)) for sign in _SIGNS)]
            self._packages = sorted({*shared, *_faces(os.path.join(self.path, 'python'))})
        return self._packages

    def install(self, package: str) -> None:
        """Nothing to do: the files stand there."""

    def executables(self, package: str) -> list[str]:
        """Names in the package's console_scripts.txt."""
        return sorted(self._entries(package))

    def program(self, package: str, executable: str) -> Program | None:
        """A built-in program."""
        entry = self._entries(package).get(executable)
        if entry is None:
            return None
        path = os.path.join(self.path, 'lib', package, executable)
        own = self.modules().get(entry[0].partition('.')[0])
        roots = () if own is None else (os.path.dirname(own),)
        return Program('entry_point', package, executable, path, entry[0], entry[1], python_roots=roots)

    def modules(self) -> dict[str, str]:
        """Those of `programs/`; the others are shared and lie on the ordinary path."""
        if self._modules is None:
            folder = os.path.join(self.path, 'programs')
            names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
            self._modules = {name: os.path.join(folder, name) for name in names}
        return self._modules

    def interface_packages(self) -> list[str]:
        """Built-in packages with interface files in their share folder."""
        return interface_packages(self.path, self.packages())

    def source_path(self, path: str) -> str | None:
        """Built-in files are where they are."""
        return None

    def _entries(self, package: str) -> dict[str, tuple[str, str]]:
        entries = self._scripts.get(package)
        if entries is None:
            entries = self._scripts[package] = {}
            try:
                with open(os.path.join(self.path, 'share', package, 'console_scripts.txt'), encoding='utf-8') as stream:
                    lines = [line.partition('#')[0] for line in stream]
            except OSError:
                lines = []  # a package without executables
            for line in filter(str.strip, lines):
                name, _, target = line.partition('=')
                module, _, function = target.strip().partition(':')
                entries[name.strip()] = (module.strip(), function.strip())
        return entries


def _faces(python: str) -> list[str]:
    """Names of the import packages that are ROS packages."""
    names = os.listdir(python) if os.path.isdir(python) else []
    return [name for name in names if name not in _NO_PACKAGES and os.path.isfile(os.path.join(python, name, '__init__.py'))]
