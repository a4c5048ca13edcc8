"""The private modules of one program.

Two copies of one node must not share globals, and each copy must have its own clock, arguments and streams. So each process
executes its own copy of the modules of a student's workspace, the main script and launch files. Their `__builtins__` have an
`__import__` that calls this module first. Everything else (the standard library, numpy, the ROS packages) is shared. Views in
`processes/module_views/` replace the few standard modules for time, random numbers, threads or the process itself. A few more
modules are executed privately, so that they use those views.
"""

from __future__ import annotations

import builtins
import os
import sys
from collections.abc import Callable, Mapping, Sequence
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import CodeType, ModuleType
from typing import Any, Protocol

from edulaunch.engine.packages.absent import REFUSED
from edulaunch.engine.processes import real_machine
from edulaunch.engine.processes.finding import Finder, Found, Overlay, code_of, namespace, read_script, regular
from edulaunch.engine.processes.frame_owner import is_own
from edulaunch.engine.processes.module_views import PRIVATE_COPIES, VIEWS, make_view

_shared_import = builtins.__import__
LOADED_FIRST = frozenset((*sys.builtin_module_names, 'io', 'os', 'posixpath'))
"""The modules that Python has loaded before it reads any file of a program."""


class Owner(real_machine.Noting, Protocol):
    """The part of a program that its loader uses."""

    argv: list[str]

    @property
    def overlay(self) -> Overlay: ...

    def path(self, path: str) -> str: ...


Compiled = dict[str, tuple[tuple[int, int], CodeType]]
"""For each path: the time of the last change with the size, and the code."""


class Loader:
    """The finder and executor of the modules of one process.

    :param process: the program that imports the modules.
    :param compiled: the compiled code that the programs of one machine share.
    :param find_lines: a function that returns the lines of a source that use the order of a set.
    :ivar finder: the finder of private modules.
    :ivar roots: the folders that are searched first.
    :ivar modules: the privately loaded modules by name (they come first in the process's `sys.modules`).
    :ivar shared: the names of the packages that this program imported and that all programs share.
    """

    def __init__(self, process: Owner, compiled: Compiled, find_lines: real_machine.FindLines) -> None:
        self.process = process
        self._find_lines = find_lines
        self.modules: dict[str, ModuleType] = {}
        self.shared: set[str] = set()
        self.finder = Finder(lambda: process.overlay.modules, self.modules)
        self.roots = self.finder.roots
        self._compiled = compiled
        self._builtins: dict[str, Any] | None = None

    @property
    def builtins(self) -> dict[str, Any]:
        """The `__builtins__` of this program's modules: Python's builtins, except for the names that depend on the process."""
        if self._builtins is None:
            self._builtins = self.import_module('builtins').__dict__
        return self._builtins

    def run_file(self, path: str, module_name: str, *, script: bool = False) -> ModuleType:
        """Execute a Python file as the module `module_name`, and return the module.

        As in Python, the folder of a script becomes the first folder of the program's search path. As in ROS 2, the folder
        of a launch file is not added.

        :param script: whether the file is a script, and not a launch file.
        :raises: any error of reading, compiling or executing the file (`FileNotFoundError`, `SyntaxError` ...).
        """
        path = os.path.abspath(self.process.path(path))
        if script:
            self.roots.insert(0, os.path.dirname(path))
        module = ModuleType(module_name)
        module.__file__ = path
        module.__package__ = '' if not script else None
        if not script:
            module.__loader__ = SourceFileLoader(module_name, path)
            module.__spec__ = ModuleSpec(module_name, module.__loader__, origin=path)
        self._execute(module, self._code(path, read_script))
        return module

    def run_module(self, name: str) -> ModuleType:
        """Execute a module of the program as `__main__` in its package, like `python -m`, and return the module.

        :raises ModuleNotFoundError: if no module has this name.
        """
        parent, _, leaf = name.rpartition('.')
        path = list(getattr(self.import_module(parent), '__path__', ())) if parent else []
        found = (regular(leaf, path) or namespace(leaf, path)) if parent else self.finder.first_match(leaf)
        if found is None:
            raise ModuleNotFoundError(f'No module named {name}', name=name)
        if found.is_package:
            return self.run_module(f'{name}.__main__')
        module = ModuleType('__main__')
        module.__file__, module.__package__ = found.path, parent
        module.__loader__ = SourceFileLoader(name, found.path)
        module.__spec__ = ModuleSpec(name, module.__loader__, origin=found.path)
        self.process.argv[0] = found.path
        self._execute(module, self._code(found.path, read_script))
        return module

    def _code(self, path: str, read: Callable[[str], CodeType]) -> CodeType:
        """Return the compiled code of a file. Copies of a program share this code until the file changes."""
        compiled, now = self._compiled, os.stat(path)
        stamp = (now.st_mtime_ns, now.st_size)
        known = compiled.get(path)
        if known is None or known[0] != stamp:
            known = compiled[path] = (stamp, read(path))
        return known[1]

    def load_entry_module(self, name: str) -> ModuleType:
        """Return the module of an entry point.

        A module of the underlay is also executed privately, but its package is shared.

        :raises ModuleNotFoundError: if no module has this name.
        """
        self.finder.own = name.partition('.')[0]
        if self.finder.last:
            return self.import_module(name)
        package = _shared_import(name.rpartition('.')[0], None, None, ['__name__'], 0)
        found = regular(name.rpartition('.')[2], list(package.__path__))
        if found is None:
            raise ModuleNotFoundError(f'No module named {name!r}', name=name)
        return self.load_file(name, found)

    def import_(
        self,
        name: str,
        globals: Mapping[str, Any] | None = None,
        locals: Mapping[str, Any] | None = None,
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> ModuleType:
        """Import a module for an `import` statement of this program, with the arguments and the result of `__import__`."""
        if level:
            name = absolute_name(name, globals or {}, level)
        top = name.partition('.')[0]
        if top in real_machine.MODULES and is_own((globals or {}).get('__file__') or '<string>'):
            real_machine.note_use(self.process, f'the module {top}')
        view = self._view(name)
        if view is not None:
            return view if fromlist or name == top else self._view(top) or _shared_import(top)
        if not self.is_private(top) and (name == top or self._view(top) is None):
            if top in REFUSED:
                raise ModuleNotFoundError(f'No module named {top!r}', name=top)
            self.shared.add(top)
            try:
                return _shared_import(name, None, None, fromlist or (), 0)
            except ModuleNotFoundError as error:
                if error.name != top or self.finder.last_match(top) is None:
                    raise
        module = self.import_module(name)
        if not fromlist:
            return self.modules.get(top, module)
        if '*' in fromlist:
            fromlist = (*fromlist, *getattr(module, '__all__', ()))
        for item in fromlist:
            if item != '*' and not hasattr(module, item) and hasattr(module, '__path__'):
                self._import_submodule(name, item)
        return module

    def import_module(self, name: str) -> ModuleType:
        """Return a module by its full name, and load its packages first. A private module takes precedence over a shared
        module.

        :raises ModuleNotFoundError: with Python's own message.
        """
        module = self.modules.get(name) or self._view(name)
        if module is not None:
            return module
        parent_name, _, leaf = name.rpartition('.')
        if not parent_name:
            return self._import_top(name)
        parent = self.import_module(parent_name)
        if self.modules.get(parent_name) is not parent:
            return self._shared(name)
        module = self.modules.get(name)
        if module is not None:  # the package itself has imported it in the meantime
            return module
        made = self._interfaces(name)
        if made is None:
            path = [] if getattr(parent, '__edulaunch_view__', False) else list(getattr(parent, '__path__', ()))
            found = regular(leaf, path) or namespace(leaf, path)
            if found is None:
                return self._not_private(name, parent)
            made = self.load_file(name, found)
        setattr(parent, leaf, made)
        return made

    def is_private(self, top: str) -> bool:
        """Return whether a top-level name belongs to a module that this program executes privately, or that its workspace
        provides.
        """
        return (
            top in self.modules
            or top in PRIVATE_COPIES
            or self.finder.first_match(top) is not None
            or top in self.process.overlay.interface_packages
        )

    def _import_top(self, name: str) -> ModuleType:
        found = self.finder.first_match(name)
        if found is None and name in PRIVATE_COPIES:
            found = Found(*PRIVATE_COPIES[name]())
        if found is None and name in self.process.overlay.interface_packages:
            package = self.modules[name] = ModuleType(name)
            package.__path__ = []
            return package
        if found is None:
            try:
                return self._shared(name)
            except ModuleNotFoundError as error:
                found = self.finder.last_match(name)
                if error.name != name or found is None:
                    raise
        return self.load_file(name, found)

    def _shared(self, name: str) -> ModuleType:
        top = name.partition('.')[0]
        if top in REFUSED:
            raise ModuleNotFoundError(f'No module named {top!r}', name=top)
        self.shared.add(top)
        _shared_import(name, None, None, (), 0)
        return sys.modules[name]

    def _interfaces(self, name: str) -> ModuleType | None:
        """Return `pkg.msg`, or a module in it, for a package whose interfaces come from the workspace. Return None for other
        packages.

        This module takes precedence over generated files.
        """
        overlay = self.process.overlay
        if name.partition('.')[0] not in overlay.interface_packages:
            return None
        spec = overlay.finder.find_spec(name)
        module = None if spec is None else overlay.finder.create_module(spec)
        if module is not None:
            module.__spec__ = spec
            module.__dict__.update({'__package__': name, '__path__': []} if name.count('.') == 1 else {})
            self.modules[name] = module
        return module

    def _not_private(self, name: str, parent: ModuleType) -> ModuleType:
        if getattr(parent, '__edulaunch_view__', False):
            return self._shared(name)
        if not hasattr(parent, '__path__'):
            raise ModuleNotFoundError(f'No module named {name!r}; {parent.__name__!r} is not a package', name=name)
        interfaces = self._interfaces_of_the_underlay(name)
        if interfaces is None:
            raise ModuleNotFoundError(f'No module named {name!r}', name=name)
        setattr(parent, name.rpartition('.')[2], interfaces)
        return interfaces

    def _interfaces_of_the_underlay(self, name: str) -> ModuleType | None:
        """Return the underlay's interfaces of a package such as turtlesim, of which the student has a copy with other modules."""
        if name.rpartition('.')[2] not in ('msg', 'srv', 'action'):
            return None
        try:
            return self._shared(name)
        except ImportError:
            return None

    def _import_submodule(self, package: str, item: str) -> None:
        try:
            self.import_module(f'{package}.{item}')
        except ModuleNotFoundError as error:
            if error.name != f'{package}.{item}':
                raise

    def _view(self, name: str) -> ModuleType | None:
        module = self.modules.get(name)
        if module is not None:
            return module if getattr(module, '__edulaunch_view__', False) else None
        if self._is_hidden(name.partition('.')[0]):
            return None
        view = make_view(name, self.process)
        if view is not None:
            self.modules[name] = view
        return view

    def _is_hidden(self, top: str) -> bool:
        """Return whether a file of the program hides a standard module, such as a `queue.py` beside the script."""
        return top in VIEWS and top not in LOADED_FIRST and self.finder.first_match(top) is not None

    def load_file(self, name: str, found: Found) -> ModuleType:
        """Execute a file as the private module `name`, or use a folder as a package. Return the module."""
        path, is_package = found
        module = ModuleType(name)
        source = None if os.path.isdir(path) else SourceFileLoader(name, path)
        module.__spec__ = spec = ModuleSpec(name, source, origin=path, is_package=is_package)
        module.__loader__ = source
        module.__package__ = name if is_package else name.rpartition('.')[0]
        if is_package:
            module.__path__ = [path if source is None else os.path.dirname(path)]
            spec.submodule_search_locations = module.__path__
        self.modules[name] = module
        if source is not None:
            module.__file__ = path
            spec._initializing = True  # type: ignore[attr-defined]  # lets Python report circular imports
            try:
                self._execute(module, self._code(path, lambda _: code_of(source)))
            except BaseException:
                del self.modules[name]
                raise
            finally:
                spec._initializing = False  # type: ignore[attr-defined]
        return module

    def reload(self, module: ModuleType) -> ModuleType:
        """Execute a private module again in its own namespace, like `importlib.reload`, and return the module."""
        file = module.__file__
        assert file is not None
        self._execute(module, code_of(SourceFileLoader(module.__name__, file)))
        return module

    def _execute(self, module: ModuleType, code: CodeType) -> None:
        """Execute code in a module, with the private builtins.

        Meanwhile, `sys.modules` contains the module if no other module has its name, because class decorators such as
        `dataclass` look it up there.
        """
        module.__dict__['__builtins__'] = self.builtins
        self.modules[module.__name__] = module
        real_machine.note_set_order(self.process, code.co_filename, self._find_lines)
        visible = sys.modules.setdefault(module.__name__, module) is module
        try:
            exec(code, module.__dict__)
        finally:
            if visible and sys.modules.get(module.__name__) is module:
                del sys.modules[module.__name__]


def absolute_name(name: str, globals: Mapping[str, Any], level: int) -> str:
    """Return the full name of a module that a relative import names.

    :param level: the number of leading dots.
    :raises ImportError: with Python's messages, outside any package or above the topmost package.
    """
    package = globals.get('__package__')
    if not package:
        raise ImportError('attempted relative import with no known parent package')
    parts = package.split('.')
    if level > len(parts):
        raise ImportError('attempted relative import beyond top-level package')
    base = '.'.join(parts[: len(parts) - level + 1])
    return f'{base}.{name}' if name else base
