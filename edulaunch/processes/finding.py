"""Where one program's own modules are: its script's folder, its package, the workspace, and what it put on `sys.path`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class Found(NamedTuple):
    """The file of a module, or the folder of a package without `__init__.py`."""

    path: str
    is_package: bool


class Finder:
    """Looks for private modules, in Python's order.

    :ivar roots: folders that come first, such as the folder of a script.
    :ivar last: folders that are searched after everything shared: the program's package folder, of which strictly only what
        its build file names is installed.
    :ivar own: the top-level module of the program's entry point, which its own folders decide.
    """

    def __init__(self, process: Process) -> None:
        self._process = process
        self.roots: list[str] = []
        self.last: list[str] = []
        self.own = ''
        self._listed: dict[str, frozenset[str]] = {}
        self._absent: dict[str, tuple[str, ...]] = {}

    def first_match(self, top: str) -> Found | None:
        """A top-level module that comes before the shared ones."""
        before, _ = self._program_path()
        folders = (*before, *self.roots)
        if self._absent.get(top) == folders:
            return None
        found = self._first_match(top, folders)
        if found is None:
            self._absent[top] = folders  # most imports are of something shared, again and again
        return found

    def _first_match(self, top: str, folders: tuple[str, ...]) -> Found | None:
        found = regular(top, [folder for folder in folders if self._may_have(folder, top)])
        if found is None and top == self.own:
            found = regular(top, self.last) or namespace(top, self.last)
        if found is None:
            place = self._process.overlay.modules.get(top)
            found = None if place is None else _at(place)
        return found

    def last_match(self, top: str) -> Found | None:
        """A top-level module for a name that nothing shared has."""
        _, after = self._program_path()
        path = [*after, *self.roots, *self.last]
        return regular(top, path) or namespace(top, path)

    def folders(self) -> list[str]:
        """Every folder that may hold a top-level module of the program, each once."""
        before, after = self._program_path()
        places = [os.path.dirname(place) for place in self._process.overlay.modules.values()]
        return list(dict.fromkeys([*before, *self.roots, *after, *self.last, *places]))

    def _may_have(self, folder: str, top: str) -> bool:
        """Whether a module can be in a folder. Each is listed once: most imports are of something else. What is written there
        later is found last.
        """
        names = self._listed.get(folder)
        if names is None:
            try:
                names = frozenset(os.listdir(folder))
            except OSError:
                names = frozenset()
            self._listed[folder] = names
        return top in names or f'{top}.py' in names

    def _program_path(self) -> tuple[list[str], list[str]]:
        """Folders that the program put on its `sys.path`, before and after the shared ones."""
        view = self._process.loader.modules.get('sys')
        return ([], []) if view is None else view.private_path()


def regular(leaf: str, path: list[str]) -> Found | None:
    """A package with `__init__.py`, or a module, in the first folder that has one."""
    for folder in path:
        base = os.path.join(folder, leaf)
        package = os.path.join(base, '__init__.py')
        if os.path.isfile(package):
            return Found(package, True)
        if os.path.isfile(base + '.py'):
            return Found(base + '.py', False)
    return None


def namespace(leaf: str, path: list[str]) -> Found | None:
    """A folder without `__init__.py` that has Python code in it, or in the folders below."""
    for folder in path:
        base = os.path.join(folder, leaf)
        if _has_code(base) or any(_has_code(os.path.join(base, name)) for name in _names(base)):
            return Found(base, True)
    return None


def _has_code(folder: str) -> bool:
    return any(name.endswith('.py') for name in _names(folder))


def _names(folder: str) -> list[str]:
    return sorted(os.listdir(folder)) if os.path.isdir(folder) else []


def _at(place: str) -> Found | None:
    if os.path.isfile(place):
        return Found(place, False)
    package = os.path.join(place, '__init__.py')
    return Found(package, True) if os.path.isfile(package) else Found(place, True) if os.path.isdir(place) else None
