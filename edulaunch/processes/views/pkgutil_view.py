"""`pkgutil` of a simulated program: data and modules of its own packages."""

from __future__ import annotations

import os
import pkgutil as real
from collections.abc import Callable, Iterable, Iterator
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def make(view: ModuleType, process: Process) -> ModuleType:
    """`get_data`, `walk_packages` and `resolve_name` look at this program's modules."""
    loader = process.loader

    def get_data(package: str, resource: str) -> bytes | None:
        module = loader.import_module(package)
        if not getattr(module, '__file__', None):
            return real.get_data(package, resource)
        with open(os.path.join(os.path.dirname(str(module.__file__)), *resource.split('/')), 'rb') as file:
            return file.read()

    def walk_packages(
        path: Iterable[str] | None = None, prefix: str = '', onerror: Callable[[str], object] | None = None
    ) -> Iterator[real.ModuleInfo]:
        for info in real.iter_modules(path, prefix):
            yield info
            if info.ispkg:
                try:
                    inner = loader.import_module(info.name).__path__
                except Exception as error:
                    if onerror is not None:
                        onerror(info.name)
                    elif not isinstance(error, ImportError):
                        raise
                else:
                    yield from walk_packages(inner, f'{info.name}.', onerror)

    def resolve_name(name: str) -> Any:
        module, colon, rest = name.partition(':')
        if not colon:
            return real.resolve_name(name)
        found: Any = loader.import_module(module)
        for part in filter(None, rest.split('.')):
            found = getattr(found, part)
        return found

    view.__dict__.update(get_data=get_data, walk_packages=walk_packages, resolve_name=resolve_name)
    copy_names(view, real)
    return view
