"""The private modules of one program.

Two copies of one node must not share globals, and each must see its own clock, arguments and streams. Modules of a student's
workspace, the main script and launch files are therefore executed once per process, with `__builtins__` whose `__import__`
comes here first. Everything else (the standard library, numpy, the ROS faces) is shared; the few standard modules that
know time, chance, threads or the process itself are replaced by views (`processes/views/`).
"""
from __future__ import annotations

import builtins
import os
import sys
from collections.abc import Mapping, Sequence
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import CodeType, ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import make_view

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

_shared_import = builtins.__import__


class Loader:
    """Finds and executes modules for one process.

    :ivar roots: folders in which private modules are looked for, first match wins.
    :ivar modules: what has been loaded privately, by name (the process's `sys.modules` shows these first).
    """

    def __init__(self, process: Process) -> None:
        self.process = process
        self.roots: list[str] = []
        self.modules: dict[str, ModuleType] = {}
        self._builtins: dict[str, Any] | None = None
        self._entry_modules: set[str] = set()

    @property
    def builtins(self) -> dict[str, Any]:
        """`__builtins__` of this program's modules: Python's own, but for what names the process."""
        if self._builtins is None:
            from edulaunch.processes.views.builtins_view import private_builtins
            self._builtins = private_builtins(self.process, self.import_)
        return self._builtins

    def run_file(self, path: str, module_name: str, *, script: bool = False) -> ModuleType:
        """Execute a Python file as a module of that name.

        A script's folder goes first on its search path, as Python does it; a launch file's does not, as in ROS 2.

        :raises: whatever reading, compiling or executing the file raises (`FileNotFoundError`, `SyntaxError` ...).
        """
        path = os.path.abspath(path)
        if script:
            self.roots.insert(0, os.path.dirname(path))
        module = ModuleType(module_name)
        module.__file__ = path
        module.__package__ = '' if not script else None
        module.__spec__ = None if script else ModuleSpec(module_name, None, origin=path)
        with open(path, 'rb') as file:
            code = compile(file.read(), path, 'exec', dont_inherit=True)
        self._execute(module, code)
        return module

    def load_entry_module(self, name: str) -> ModuleType:
        """The module of an entry point. One of the underlay is executed privately too, its package is shared."""
        if self._locate(name.partition('.')[0], self.search_path()) is not None:
            return self.import_module(name)
        package = _shared_import(name.rpartition('.')[0], None, None, ['__name__'], 0)
        found = self._locate(name.rpartition('.')[2], list(package.__path__))
        if found is None:
            raise ModuleNotFoundError(f'No module named {name!r}', name=name)
        return self._load(name, *found)

    def search_path(self) -> list[str]:
        """Where private modules are looked for now: the roots, and what the program put on its `sys.path`."""
        view = self.modules.get('sys')
        return [*self.roots, *view.private_path()] if view is not None else self.roots

    def import_(self, name: str, globals: Mapping[str, Any] | None = None, locals: Mapping[str, Any] | None = None,
                fromlist: Sequence[str] | None = (), level: int = 0) -> ModuleType:
        """What `import` statements of this program call."""
        if level:
            name = self._absolute(name, globals or {}, level)
        top = name.partition('.')[0]
        private = self._view(name) or self._view(top)
        if private is None and not self._is_private(top):
            return _shared_import(name, None, None, fromlist or (), 0)
        module = private if private is not None and (self._view(name) or not fromlist) else self.import_module(name)
        if not fromlist:
            return self.modules.get(top, module)
        for item in fromlist:
            if item != '*' and not hasattr(module, item) and hasattr(module, '__path__'):
                self._import_submodule(name, item)
        return module

    def import_module(self, name: str) -> ModuleType:
        """Load a private module by its full name, its packages first.

        :raises ModuleNotFoundError: with Python's own text.
        """
        module = self.modules.get(name)
        if module is not None:
            return module
        parent_name, _, leaf = name.rpartition('.')
        path: list[str] = self.search_path()
        parent = None
        if parent_name:
            parent = self.import_module(parent_name)
            path = list(getattr(parent, '__path__', ()))
        found = self._locate(leaf, path)
        if found is None:
            return self._not_private(name, parent)
        module = self._load(name, *found)
        if parent is not None:
            setattr(parent, leaf, module)
        return module

    def _not_private(self, name: str, parent: ModuleType | None) -> ModuleType:
        if parent is None or getattr(parent, '__edulaunch_view__', False):
            _shared_import(name, None, None, (), 0)
            return sys.modules[name]
        if not hasattr(parent, '__path__'):
            raise ModuleNotFoundError(f'No module named {name!r}; {parent.__name__!r} is not a package', name=name)
        interfaces = self._interface_module(name)
        if interfaces is None:
            raise ModuleNotFoundError(f'No module named {name!r}', name=name)
        setattr(parent, name.rpartition('.')[2], interfaces)
        return interfaces

    def _interface_module(self, name: str) -> ModuleType | None:
        """A package may hold nodes and interfaces: `pkg.msg` is then made from its .msg files."""
        if name.rpartition('.')[2] not in ('msg', 'srv', 'action'):
            return None
        try:
            _shared_import(name, None, None, ('__name__',), 0)
        except ImportError:
            return None
        return sys.modules.get(name)

    def _import_submodule(self, package: str, item: str) -> None:
        try:
            self.import_module(f'{package}.{item}')
        except ModuleNotFoundError as error:
            if error.name != f'{package}.{item}':
                raise

    def _absolute(self, name: str, globals: Mapping[str, Any], level: int) -> str:
        package = globals.get('__package__')
        if not package:
            raise ImportError('attempted relative import with no known parent package')
        parts = package.split('.')
        if level > len(parts):
            raise ImportError('attempted relative import beyond top-level package')
        base = '.'.join(parts[:len(parts) - level + 1])
        return f'{base}.{name}' if name else base

    def _view(self, name: str) -> ModuleType | None:
        module = self.modules.get(name)
        if module is not None:
            return module if getattr(module, '__edulaunch_view__', False) else None
        view = make_view(name, self.process)
        if view is not None:
            self.modules[name] = view
        return view

    def _is_private(self, top: str) -> bool:
        return top in self.modules or self._locate(top, self.search_path()) is not None

    @staticmethod
    def _locate(leaf: str, path: list[str]) -> tuple[str, bool] | None:
        """The file of a module and whether it is a package; a folder without `__init__.py` counts where Python code is in it."""
        for folder in path:
            base = os.path.join(folder, leaf)
            package = os.path.join(base, '__init__.py')
            if os.path.isfile(package):
                return package, True
            if os.path.isfile(base + '.py'):
                return base + '.py', False
        for folder in path:
            base = os.path.join(folder, leaf)
            if os.path.isdir(base) and any(name.endswith('.py') for name in sorted(os.listdir(base))):
                return base, True
        return None

    def _load(self, name: str, path: str, is_package: bool) -> ModuleType:
        module = ModuleType(name)
        module.__spec__ = ModuleSpec(name, None, origin=path, is_package=is_package)
        module.__package__ = name if is_package else name.rpartition('.')[0]
        if is_package:
            module.__path__ = [path if os.path.isdir(path) else os.path.dirname(path)]
        self.modules[name] = module
        if not os.path.isdir(path):
            module.__file__ = path
            try:
                self._execute(module, code_of(name, path))
            except BaseException:
                del self.modules[name]
                raise
        return module

    def _execute(self, module: ModuleType, code: CodeType) -> None:
        """Run the code with the private builtins. While it runs, `sys.modules` shows the module where that name is free:
        class decorators such as `dataclass` look their module up there.
        """
        module.__dict__['__builtins__'] = self.builtins
        self.modules[module.__name__] = module
        visible = sys.modules.setdefault(module.__name__, module) is module
        try:
            exec(code, module.__dict__)
        finally:
            if visible and sys.modules.get(module.__name__) is module:
                del sys.modules[module.__name__]


def code_of(name: str, path: str) -> CodeType:
    """The compiled code of a source file, through Python's own cache of compiled files."""
    code = SourceFileLoader(name, path).get_code(name)
    assert code is not None
    return code
