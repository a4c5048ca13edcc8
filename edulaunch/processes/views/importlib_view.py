"""`importlib` of a simulated program: modules of the program are found first, each where `import` statements find it."""

from __future__ import annotations

import importlib as real
import os
import sys
from collections.abc import Callable
from importlib.machinery import ModuleSpec, SourceFileLoader
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.finding import namespace, regular
from edulaunch.processes.loader import absolute_name
from edulaunch.processes.views import copy_names
from edulaunch.processes.views.files_view import inside

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

SUBMODULES = ('metadata', 'resources', 'util')


class ImportlibView(ModuleType):
    """`importlib`, whose submodules of the program's own come when they are asked for."""

    def __init__(self, process: Process) -> None:
        super().__init__('importlib')
        self.__edulaunch_view__ = True
        self._process = process

    def __getattr__(self, name: str) -> Any:
        if name in SUBMODULES:
            return self._process.loader.import_module(f'importlib.{name}')
        return getattr(real, name)


def make(view: ModuleType, process: Process) -> ModuleType:
    """`import_module`, `reload` and `__import__` of this program."""
    loader = process.loader

    def import_module(name: str, package: str | None = None) -> ModuleType:
        level = len(name) - len(name.lstrip('.'))
        if level and not package:
            raise TypeError(f"the 'package' argument is required to perform a relative import for {name!r}")
        return loader.import_module(absolute_name(name[level:], {'__package__': package}, level) if level else name)

    def reload(module: ModuleType) -> ModuleType:
        own = loader.modules.get(module.__name__) is module and getattr(module, '__file__', None)
        return loader.reload(module) if own else real.reload(module)

    made = ImportlibView(process)
    made.__dict__.update(import_module=import_module, reload=reload, __import__=loader.import_)
    for name in [name for name in real.__dict__ if name not in SUBMODULES and name not in made.__dict__]:
        made.__dict__[name] = real.__dict__[name]
    return made


def make_resources(view: ModuleType, process: Process) -> ModuleType:
    """`importlib.resources`: a package may be given by name, or left out, and is then this program's own."""
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
    """`importlib.util`: finds the program's own modules; one that is made from a spec runs as the program's own."""
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
