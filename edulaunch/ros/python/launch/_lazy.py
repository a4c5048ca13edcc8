"""Packages whose names are imported when they are first used, and ROS 2's paths of modules that are one file here.

`import launch` must be quick, and a launch file uses a handful of launch's ninety classes. Upstream imports them all, each from
a module of its own. Here related ones share a file; `launch.actions.set_environment_variable` can be imported all the same (it
is the file with all actions on the environment), and the classes say that they are from there, as ROS 2's error messages do.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from importlib import import_module
from importlib.machinery import ModuleSpec
from typing import Any

_NAMES: dict[str, dict[str, str]] = {}
"""Module of ours -> the names in it -> the modules, relative to the package, that define them in ROS 2."""
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
    def exec_module(module: Any) -> None:
        """Put the module of ours in the place of the new one, as importing allows."""
        sys.modules[module.__name__] = import_module(_FILES[module.__name__])


LOADER: Any = RosPaths
sys.meta_path.append(LOADER)


def _entries(words: str) -> Iterator[tuple[str, str]]:
    """(name, module that defines it in ROS 2) of each word: `name=module`, or `AName` alone for one of `a_name`."""
    for word in words.split():
        name, _, path = word.partition('=')
        letters = [f'_{b}' if a.islower() and b.isupper() else b for a, b in zip(f' {name}', name, strict=False)]
        yield name, path or ''.join(letters).lower()


def has_ros_paths(module: str, words: str | None = None) -> None:
    """Called at the end of a file that is several modules in ROS 2: it can be imported as each, and its names are from there.

    :param words: for a file that is a package in ROS 2: its names, as those of a file in :func:`lazy_exports`; they are added to
        `__all__`. None for the files of a package of ours.
    """
    here: Any = sys.modules[module]
    package = module.rpartition('.')[0] if words is None else module
    names = _NAMES[module] if words is None else dict(_entries(words))
    for name, path in names.items():
        full = f'{package}.{path}'
        sys.modules[full] = here
        value = getattr(here, name)
        if getattr(value, '__module__', None) == module:
            value.__module__ = full
        if words is not None:
            here.__dict__.setdefault(path, here)
    if words is not None:
        here.__dict__.setdefault('__path__', [])
        here.__all__ = [*names, *getattr(here, '__all__', ())]
        here.__dir__ = lambda: sorted(here.__all__)


def lazy_exports(
    package: str, exports: Mapping[str, str], absent: Mapping[str, str] | None = None
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Make the `__getattr__` and `__dir__` of a package that loads its `exports` late, and add their names to its `__all__`.

    The sub-modules themselves are attributes too, as they are upstream
    (`launch.actions.timer_action.TimerAction`). A name that is not there gives Python's own AttributeError
    (which `from package import name` turns into ImportError).

    :param exports: sub-module of ours -> its exported names with blanks between, each as `name=module` with the sub-module that
        defines it in ROS 2, or alone when that is called as the name (`a_name` for `AName`); `=module` for such a module of
        which nothing is exported. A file that is several modules in ROS 2 calls :func:`has_ros_paths`. Below '' the sub-modules
        that are exported themselves, and as `=module` those that only `dir` shows.
    :param absent: names of ROS 2 that are not here, each with what to use in its place; asked for, they are an ImportError.
    """
    here: Any = sys.modules[package]
    here.__all__ = list(getattr(here, '__all__', ()))
    homes: dict[str, str] = {}
    modules: set[str] = set()
    for file, words in exports.items():
        entries = list(_entries(words))
        modules |= {path for _, path in entries} | {file}
        homes.update({name or path: file for name, path in entries if name or not file})
        here.__all__ += [name for name, _ in entries if name]
        if file:
            _NAMES[f'{package}.{file}'] = {name: path for name, path in entries if name}
            _FILES.update({f'{package}.{path}': f'{package}.{file}' for _, path in entries if path != file})

    def __getattr__(name: str) -> Any:
        value: Any
        if homes.get(name):
            value = getattr(import_module(f'{package}.{homes[name]}'), name)
        elif name and name in modules:
            value = import_module(f'{package}.{name}')
        elif absent and name in absent:
            raise ImportError(
                f'cannot import name {name!r} from {package!r}\n  help: it is not part of edulaunch: {absent[name]}'
            )
        else:
            raise AttributeError(f'module {package!r} has no attribute {name!r}')
        setattr(here, name, value)
        return value

    return __getattr__, lambda: sorted({*here.__all__, *homes})
