"""Finds a program's own modules in its script's folder, its package, the workspaces, and its changes to `sys.path`.

The module also returns the compiled code of these modules. The additions of a workspace to the underlay are read once per index,
on first use.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Mapping
from functools import cached_property, lru_cache
from importlib.machinery import SourceFileLoader
from types import CodeType
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.engine.interfaces.importer import InterfaceFinder
from edulaunch.engine.interfaces.registry import answer_with
from edulaunch.engine.packages.index import interfaces_of
from edulaunch.engine.sim.task import running_task

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.importer import InterfaceFinder
    from edulaunch.engine.interfaces.registry import Registry
    from edulaunch.engine.packages import Index


class Found(NamedTuple):
    """The file of a module, or the folder of a package without `__init__.py`."""

    path: str
    is_package: bool


class Finder:
    """A finder of the private modules of one program. It searches in the same order as Python.

    :param installed: a function that returns the modules of the workspaces, name -> folder or .py file.
    :param loaded: the modules that the program has loaded privately. This includes its `sys`, to whose `path` the program may
        have added folders.
    :ivar roots: folders that are searched first, such as the folder of a script.
    :ivar last: folders that are searched after all shared modules. One of them is the program's package folder, although only the
        files in its build file would be installed.
    :ivar own: the top-level module of the program's entry point, which is loaded from the program's own folders.
    """

    def __init__(self, installed: Callable[[], Mapping[str, str]], loaded: Mapping[str, Any]) -> None:
        self._installed = installed
        self._loaded = loaded
        self.roots: list[str] = []
        self.last: list[str] = []
        self.own = ''
        self._listed: dict[str, frozenset[str]] = {}
        self._absent: dict[str, tuple[str, ...]] = {}

    def first_match(self, top: str) -> Found | None:
        """Return a private top-level module that takes precedence over a shared module, or None if there is no such module."""
        before, _ = self._program_path()
        folders = (*before, *self.roots)
        if self._absent.get(top) == folders:
            return None
        found = self._first_match(top, folders)
        if found is None:
            self._absent[top] = folders  # most imports are repeated imports of shared modules
        return found

    def _first_match(self, top: str, folders: tuple[str, ...]) -> Found | None:
        found = regular(top, [folder for folder in folders if self._may_have(folder, top)])
        if found is None and top == self.own:
            found = regular(top, self.last) or namespace(top, self.last)
        if found is None:
            place = self._installed().get(top)
            found = None if place is None else _at(place)
        return found

    def last_match(self, top: str) -> Found | None:
        """Return a private top-level module for a name that no shared module has. Return None if there is no such module."""
        _, after = self._program_path()
        path = [*after, *self.roots, *self.last]
        return regular(top, path) or namespace(top, path)

    def folders(self) -> list[str]:
        """Return every folder that may contain a top-level module of the program, without duplicates."""
        before, after = self._program_path()
        places = [os.path.dirname(place) for place in self._installed().values()]
        return list(dict.fromkeys([*before, *self.roots, *after, *self.last, *places]))

    def _may_have(self, folder: str, top: str) -> bool:
        """Return whether a folder may contain a module.

        Each folder is listed only once, because most imports are of other modules. Files that a program writes later are found by
        :meth:`last_match`.
        """
        names = self._listed.get(folder)
        if names is None:
            try:
                names = frozenset(os.listdir(folder))
            except (FileNotFoundError, NotADirectoryError, PermissionError):
                names = frozenset()
            self._listed[folder] = names
        return top in names or f'{top}.py' in names

    def _program_path(self) -> tuple[list[str], list[str]]:
        """Return two lists of folders that the program added to its `sys.path`: before the shared folders, and after them."""
        view = self._loaded.get('sys')
        return ([], []) if view is None else view.private_path()


def regular(leaf: str, path: list[str]) -> Found | None:
    """Return a module, or a package with `__init__.py`, from the first folder that contains one. Return None if no folder
    does.
    """
    for folder in path:
        base = os.path.join(folder, leaf)
        package = os.path.join(base, '__init__.py')
        if os.path.isfile(package):
            return Found(package, True)
        if os.path.isfile(base + '.py'):
            return Found(base + '.py', False)
    return None


def namespace(leaf: str, path: list[str]) -> Found | None:
    """Return a package without `__init__.py` that has Python files in its folder or one level deeper. Return None if there is
    no such package.
    """
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


class Overlay:
    """The modules and interfaces of one index that its programs can import."""

    def __init__(self, index: Index) -> None:
        self._index = index

    @cached_property
    def modules(self) -> dict[str, str]:
        """The top-level modules of the workspaces, as their build files install them: name -> folder or .py file."""
        return self._index.python_modules()

    @cached_property
    def _interfaces(self) -> tuple[frozenset[str], Registry]:
        return interfaces_of(self._index)

    @property
    def interface_packages(self) -> frozenset[str]:
        """The packages whose interfaces come from a workspace."""
        return self._interfaces[0]

    @property
    def registry(self) -> Registry:
        """The interfaces for programs that use this index."""
        return self._interfaces[1]

    @cached_property
    def finder(self) -> InterfaceFinder:
        """The finder that creates modules such as `my_interfaces.msg`. It is not on `sys.meta_path`, so no other code uses it."""
        return InterfaceFinder(self.registry)


def _registry_of_the_running_program() -> Registry | None:
    task = running_task()
    owner = None if task is None else task.owner
    overlay: Overlay | None = None if owner is None else owner.overlay
    return overlay.registry if overlay is not None and overlay.interface_packages else None


answer_with(_registry_of_the_running_program)


def read_script(path: str) -> CodeType:
    """Return the compiled code of a script or launch file. Python does not cache the compiled code of such a file.

    :raises: any error of the compilation.
    """
    with open(path, 'rb') as file:
        source = file.read()
    return _flawless(source, path, tuple(warnings.filters)) or compile(source, path, 'exec', dont_inherit=True)


@lru_cache(maxsize=64)
def _flawless(source: bytes, path: str, filters: tuple[Any, ...]) -> CodeType | None:
    """Return the compiled code of a source file, or None if the compilation causes errors or warnings.

    The code is cached for the next run, because a notebook or a grader runs a file many times. Errors and warnings are not
    cached, because they should appear each time. (`catch_warnings` cannot be used here, because it makes Python forget which
    warnings it has shown. A first run would then show more warnings than a second run.)

    :param filters: the active filters, which decide which warnings appear.
    """
    shown: list[Any] = []
    before, warnings.showwarning = warnings.showwarning, lambda *warning, **more: shown.append(warning)
    try:
        code = compile(source, path, 'exec', dont_inherit=True)
    except Exception:
        return None
    finally:
        warnings.showwarning = before
    return None if shown else code


def code_of(source: SourceFileLoader) -> CodeType:
    """Return the compiled code of a source file, with Python's own cache of compiled files."""
    code = source.get_code(source.name)
    assert code is not None
    return code
