"""Packages whose names are imported when they are first used, and ROS 2's paths of modules that are one file here.

`import launch` must be quick, and a launch file uses a handful of launch's ninety classes. Upstream imports them all, each from
a module of its own. Here related ones share a file; `launch.actions.set_environment_variable` can be imported all the same (it
is the file with all actions on the environment), and the classes say that they are from there, as ROS 2's error messages do.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from importlib import import_module
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

Exports = dict[str, str]
"""Exported name -> the sub-module (relative to the package) that defines it in ROS 2; '' for a name that is a sub-module."""

_NAMES: dict[str, Exports] = {}
"""Module of ours -> the names in it that ROS 2 defines in other modules -> those, relative to the package."""
_FILES: dict[str, str] = {}
"""Path of a module in ROS 2 -> the module of ours that has what is there."""


class RosPaths:
    """Finds a module under its path in ROS 2 (the last in `sys.meta_path`, so asked for nothing that has a file)."""

    @staticmethod
    def find_spec(name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Where to look for it: here, when it is one of ours."""
        return ModuleSpec(name, LOADER) if name in _FILES else None

    @staticmethod
    def create_module(spec: ModuleSpec) -> None:
        """Nothing to make: there is one."""

    @staticmethod
    def exec_module(module: ModuleType) -> None:
        """Put the module of ours in the place of the new one, as importing allows."""
        sys.modules[module.__name__] = import_module(_FILES[module.__name__])


LOADER: Any = RosPaths
sys.meta_path.append(LOADER)


def has_ros_paths(module: str, names: Exports | None = None) -> None:
    """Called at the end of a file that is several modules in ROS 2: it can be imported as each, and its names are from there.

    :param names: for a file that is a package in ROS 2: its names as in :data:`Exports`. None for the files of a package of ours.
    """
    here: Any = sys.modules[module]
    package = module.rpartition('.')[0] if names is None else module
    for name, path in (_NAMES[module] if names is None else names).items():
        full = f'{package}.{path}'
        sys.modules[full] = here
        value = getattr(here, name)
        if getattr(value, '__module__', None) == module:
            value.__module__ = full
        if names is not None:
            here.__dict__.setdefault(path, here)
    if names is not None:
        here.__dict__.setdefault('__path__', [])
        here.__dict__.setdefault('__dir__', lambda: sorted(names))


def lazy_exports(
    package: str, exports: Exports, files: Mapping[str, tuple[str, ...]] | None = None, absent: Mapping[str, str] | None = None
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Make the `__getattr__` and `__dir__` of a package that loads its `exports` late.

    The sub-modules themselves are attributes too, as they are upstream
    (`launch.actions.timer_action.TimerAction`). A name that is not there gives Python's own AttributeError
    (which `from package import name` turns into ImportError).

    :param files: sub-module of ours -> the other sub-modules that it is in ROS 2; it calls :func:`has_ros_paths`.
    :param absent: names of ROS 2 that are not here, each with what to use in its place; asked for, they are an ImportError.
    """
    modules = {*exports.values(), *(name for name, module in exports.items() if not module)}
    for file, paths in (files or {}).items():
        modules |= {file, *paths}
        _NAMES[f'{package}.{file}'] = {name: module for name, module in exports.items() if module in paths}
        _FILES.update(dict.fromkeys([f'{package}.{path}' for path in paths], f'{package}.{file}'))

    def __getattr__(name: str) -> Any:
        value: Any
        if name in exports and exports[name]:
            value = getattr(import_module(f'{package}.{exports[name]}'), name)
        elif name and name in modules:
            value = import_module(f'{package}.{name}')
        elif absent and name in absent:
            raise ImportError(
                f'cannot import name {name!r} from {package!r}\n  help: it is not part of edulaunch: {absent[name]}'
            )
        else:
            raise AttributeError(f'module {package!r} has no attribute {name!r}')
        setattr(sys.modules[package], name, value)
        return value

    def __dir__() -> list[str]:
        return sorted(exports)

    return __getattr__, __dir__
