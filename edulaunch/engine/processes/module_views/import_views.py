"""`builtins`, `importlib` and `pickle` of a simulated program. They find the program's own modules first, in the same places as
`import` statements.
"""

from __future__ import annotations

import builtins
import importlib
import os
import sys
from collections.abc import Callable
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.finding import Found, namespace, regular
from edulaunch.engine.processes.loader import absolute_name
from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.processes.module_views.file_views import inside
from edulaunch.engine.processes.real_machine import private_hash

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process


def make_builtins(view: ModuleType, process: Process) -> ModuleType:
    """Make a `builtins` with the builtins of this program, including names that the program adds or replaces."""
    view.__dict__.update(_private_builtins(process, process.loader.import_))
    return view


def _private_builtins(process: Process, import_: Callable[..., Any]) -> dict[str, Any]:
    """Return Python's builtins with this process's versions of functions such as `print`, `open` and `__import__`."""

    def private_print(
        *values: object, sep: str | None = None, end: str | None = None, file: Any = None, flush: bool = False
    ) -> None:
        if file is None:
            view: Any = process.loader.modules.get('sys')
            file = process.streams.stdout if view is None else view.stdout
        file.write((' ' if sep is None else sep).join(map(str, values)) + ('\n' if end is None else end))
        if flush:
            file.flush()

    def private_input(prompt: object = '') -> str:
        view: Any = process.loader.modules.get('sys') or process.streams
        view.stdout.write(str(prompt))
        line: str = view.stdin.readline()
        if not line:
            raise EOFError('EOF when reading a line')
        return line.rstrip('\n')

    def private_open(file: Any, *arguments: Any, **options: Any) -> Any:
        if process.cwd is not None and not isinstance(file, int):
            file = os.path.join(os.fsencode(process.cwd) if isinstance(file, bytes) else process.cwd, file)
        return open(file, *arguments, **options)

    def private_exit(code: object = None) -> None:
        raise SystemExit(code)

    def private_breakpoint(*_: Any, **__: Any) -> None:
        process.note('breakpoint', f'{process.name} called breakpoint(): it has no terminal, so it continues')

    return {
        **builtins.__dict__,
        'breakpoint': private_breakpoint,
        '__import__': import_,
        'print': private_print,
        'input': private_input,
        'open': private_open,
        'hash': private_hash(process),
        'exit': private_exit,
        'quit': private_exit,
    }


SUBMODULES = ('metadata', 'resources', 'util')


class ImportlibView(ModuleType):
    """A view of `importlib` that loads the program's own versions of submodules on first use."""

    def __init__(self, process: Process) -> None:
        super().__init__('importlib')
        self.__edulaunch_view__ = True
        self._process = process

    def __getattr__(self, name: str) -> Any:
        if name in SUBMODULES:
            return self._process.loader.import_module(f'importlib.{name}')
        return getattr(importlib, name)


def make_importlib(view: ModuleType, process: Process) -> ModuleType:
    """Make an `importlib` with this program's versions of `import_module`, `reload` and `__import__`."""
    loader = process.loader

    def import_module(name: str, package: str | None = None) -> ModuleType:
        level = len(name) - len(name.lstrip('.'))
        if level and not package:
            raise TypeError(f"the 'package' argument is required to perform a relative import for {name!r}")
        return loader.import_module(absolute_name(name[level:], {'__package__': package}, level) if level else name)

    def reload(module: ModuleType) -> ModuleType:
        own = loader.modules.get(module.__name__) is module and getattr(module, '__file__', None)
        return loader.reload(module) if own else importlib.reload(module)

    made = ImportlibView(process)
    made.__dict__.update(import_module=import_module, reload=reload, __import__=loader.import_)
    for name in [name for name in importlib.__dict__ if name not in SUBMODULES and name not in made.__dict__]:
        made.__dict__[name] = importlib.__dict__[name]
    return made


def make_resources(view: ModuleType, process: Process) -> ModuleType:
    """Make an `importlib.resources` that finds this program's own packages.

    Its functions accept a package, the name of a package, or None for the package of the caller.
    """
    import importlib.resources as real_resources

    def of_this_program(function: Callable[..., Any]) -> Callable[..., Any]:
        def call(anchor: Any = None, *arguments: Any, **options: Any) -> Any:
            if anchor is None:
                anchor = sys._getframe(1).f_globals.get('__package__')
            return function(process.loader.import_module(anchor) if isinstance(anchor, str) else anchor, *arguments, **options)

        return call

    for name in ('contents', 'files', 'is_resource', 'open_binary', 'open_text', 'path', 'read_binary', 'read_text'):
        if hasattr(real_resources, name):
            view.__dict__[name] = of_this_program(getattr(real_resources, name))
    copy_names(view, real_resources)
    return view


def make_util(view: ModuleType, process: Process) -> ModuleType:
    """Make an `importlib.util` that finds the program's own modules. A module that is created from a spec is private to the
    program.
    """
    import importlib.util as real_util

    loader = process.loader

    def find_spec(name: str, package: str | None = None) -> ModuleSpec | None:
        parent, _, leaf = name.rpartition('.')
        if not loader.is_private(name.partition('.')[0]):
            return real_util.find_spec(name, package)
        path = list(getattr(loader.import_module(parent), '__path__', ())) if parent else []
        found = (regular(leaf, path) or namespace(leaf, path)) if parent else loader.finder.first_match(leaf)
        if found is None:
            return None
        return ModuleSpec(name, SourceFileLoader(name, found.path), origin=found.path, is_package=found.is_package)

    def module_from_spec(spec: ModuleSpec) -> ModuleType:
        module = real_util.module_from_spec(spec)
        module.__dict__['__builtins__'] = loader.builtins
        return module

    def spec_from_file_location(name: str, location: Any = None, **options: Any) -> ModuleSpec | None:
        return real_util.spec_from_file_location(name, location if location is None else inside(os.fspath(location)), **options)

    view.__dict__.update(find_spec=find_spec, module_from_spec=module_from_spec, spec_from_file_location=spec_from_file_location)
    copy_names(view, real_util)
    return view


NAMES = ('dump', 'dumps', 'load', 'loads', 'Pickler', 'Unpickler')


def make_pickle(view: ModuleType, process: Process) -> ModuleType:
    """Execute the standard module privately, and use its functions in Python instead of the functions in C.

    The functions in C search for classes in modules that all programs share.
    """
    spec = PathFinder.find_spec('pickle')
    assert spec is not None and spec.origin is not None
    made: Any = process.loader.load_file('pickle', Found(spec.origin, False))
    made._Pickler = _pickler_class(made)
    made.__dict__.update({name: made.__dict__[f'_{name}'] for name in NAMES}, __edulaunch_view__=True)
    return made  # type: ignore[no-any-return]


def _pickler_class(pickle: Any) -> type:
    import datetime

    class Pickler(pickle._Pickler):  # type: ignore[misc]
        """The simulated `pickle.Pickler`. It saves the real `datetime` and `date` by name, so that loading returns the
        program's classes.
        """

        def save_global(self, obj: Any, name: str | None = None) -> None:
            """Write a class or function by name."""
            if obj is not datetime.datetime and obj is not datetime.date:
                super().save_global(obj, name)
                return
            if self.proto >= 4:
                self.save('datetime')
                self.save(obj.__name__)
                self.write(pickle.STACK_GLOBAL)
            else:
                self.write(pickle.GLOBAL + f'datetime\n{obj.__name__}\n'.encode())
            self.memoize(obj)

    return Pickler
