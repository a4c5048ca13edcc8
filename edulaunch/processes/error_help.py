"""One line of help for an exception that ended a program: what Python and ROS leave unsaid."""

from __future__ import annotations

import os
import re
import sys
from importlib.machinery import PathFinder
from typing import TYPE_CHECKING, Any

from edulaunch.nearest import nearest
from edulaunch.packages.absent import absent_module_kind
from edulaunch.processes.compiled_modules import compiled_module, missing_library
from edulaunch.processes.with_help import with_help

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

INTERFACE_ENDINGS = ('_msgs', '_srvs', '_interfaces', '_interface', '_msg', '_srv', '_actions')
SPELLING = ('rclpy', 'launch', 'launch_ros', 'tf2_ros', 'tf_transformations')


def error_help(process: Process, error: BaseException) -> str | None:
    """What to try, or None. An `edulaunch_hint` on the error goes before everything else."""
    hint: str | None = getattr(error, 'edulaunch_hint', None)
    if hint is not None:
        return hint
    if type(error) is ModuleNotFoundError and error.name:  # importlib.metadata's kind of it is not about modules
        return _module_help(process, error.name)
    if isinstance(error, ImportError | OSError) and (library := missing_library(error)):
        return f'{wanted_by(process)} needs the native library {library!r}, which this machine does not have'
    if isinstance(error, ImportError):
        return _hiding_help(process, error.name) or _name_help(process, error)
    if help := with_help(error):
        return help
    if isinstance(error, AttributeError):
        if hiding := _hiding_help(process, getattr(error.obj, '__name__', None)):
            return hiding
        from edulaunch.interfaces import current_registry
        from edulaunch.interfaces.attribute_help import attribute_help

        return attribute_help(error, current_registry())
    return None


def _hiding_help(process: Process, name: Any) -> str | None:
    """For something that a standard module has, when a file of the student has its name."""
    own = process.loader.modules.get(name) if name in sys.stdlib_module_names else None
    file = getattr(own, '__file__', None)
    if file is None or file == getattr(PathFinder.find_spec(name), 'origin', None):
        return None
    return f"{file} is taken for Python's module {name!r}: give it another name"


def _module_help(process: Process, name: str) -> str | None:
    """For a module that nobody has: what it is, which program wanted it, and the nearest name."""
    top = name.partition('.')[0]
    if compiled := _compiled_help(process, name):
        return compiled
    if name != top and _parent_is_there(process, name):
        return _part_help(process, name) or _package_help(process, top)
    kind = absent_module_kind(top)
    if kind is not None:
        return f'{wanted_by(process)} needs the module {top!r} ({kind}), which is not here; the other programs go on without it'
    return _package_help(process, top) or f'{wanted_by(process)} needs the module {top!r}, which is not here' + _near(
        process, top
    )


def _compiled_help(process: Process, name: str) -> str | None:
    """For a module that is there, but is no Python."""
    compiled = compiled_module(process, name)
    return (
        None
        if compiled is None
        else (
            f'{wanted_by(process)} needs the module {name!r}, which is {compiled}; '
            'only Python runs here, and the other programs go on without it'
        )
    )


def wanted_by(process: Process) -> str:
    """The program in words: 'follower-2 (follower of my_robot)'."""
    spec = process.spec
    return f'{process.name} ({spec.executable} of {spec.package})' if spec.package and spec.executable else process.name


def _package_help(process: Process, top: str) -> str | None:
    """For a package of the workspace whose interfaces or modules are not installed."""
    if top not in process.index.packages():
        return None
    if top in process.overlay.interface_packages:
        return f'{top} has other interfaces: {", ".join(_kinds(process, top))}'
    return (
        f'the package {top!r} is there but installs no module of that name: are its interfaces in '
        'rosidl_generate_interfaces() of CMakeLists.txt, or its Python package in packages= of setup.py?'
    )


def _kinds(process: Process, package: str) -> list[str]:
    return [f'{package}.{kind}' for kind in ('msg', 'srv', 'action') if process.overlay.registry.has(package, kind)]


def _name_help(process: Process, error: ImportError) -> str | None:
    """For a name that a module of the program does not have: the nearest one, or that two modules import each other."""
    said = re.match("cannot import name '(.+?)' from (partially initialized module )?", str(error))
    if said is None or '\n' in str(error):
        return None
    if said[2]:
        return f'{error.name} is still being imported: two modules import each other. Import inside the function that needs it'
    if compiled := _compiled_help(process, f'{error.name}.{said[1]}'):
        return compiled
    module = process.loader.modules.get(error.name or '')
    if module is None:
        return None
    names = [name for name in vars(module) if not name.startswith('__')]
    near = nearest(said[1], names)
    return f'did you mean {near!r}?' if near else f'{error.name} defines: {", ".join(names)}' if 0 < len(names) < 12 else None


def _parent_is_there(process: Process, name: str) -> bool:
    parent = name.rpartition('.')[0]
    return parent in process.loader.modules or parent in sys.modules


def _is_module(path: str) -> bool:
    return path.endswith('.py') or os.path.isfile(os.path.join(path, '__init__.py'))


def _part_help(process: Process, name: str) -> str | None:
    """For a missing part of a package that is there: the nearest module beside it."""
    parent, _, leaf = name.rpartition('.')
    module: Any = process.loader.modules.get(parent) or sys.modules[parent]
    beside = sorted(
        {
            os.path.splitext(entry)[0]
            for folder in getattr(module, '__path__', ())
            if os.path.isdir(folder)
            for entry in os.listdir(folder)
            if not entry.startswith('_') and _is_module(os.path.join(folder, entry))
        }
    )
    near = nearest(leaf, beside)
    if near is not None:
        return f'did you mean {parent}.{near}?'
    return f'modules of {parent}: {", ".join(beside)}' if beside else f'{parent} has no such module'


def _alike(name: str, near: str) -> bool:
    """Whether only a letter or two differ: modules of other projects are called much like ROS's."""
    from difflib import SequenceMatcher

    return SequenceMatcher(None, name, near).ratio() >= 0.8


def _near(process: Process, top: str) -> str:
    from edulaunch.interfaces import current_registry

    known = {*current_registry().packages(), *process.overlay.modules, *SPELLING}
    ending = next((ending for ending in INTERFACE_ENDINGS if top.endswith(ending)), '')
    near = nearest(top.removesuffix(ending), [name.removesuffix(ending) for name in known if name.endswith(ending)])
    if near and (ending or _alike(top, near)):
        return f'; did you mean {near + ending!r}?'
    if ending:
        return ': is the package with these interfaces in the workspace?'
    return f'. If it is no module of yours, try: pip install {top}'
