"""Facts about an error that ended a program, in addition to its message, as plain data for `edulaunch.advice`.

For example, a missing module may exist as compiled code, or a build may create it. Another example is a `with` statement with a
ROS object that is not a context manager.
"""

from __future__ import annotations

import linecache
import os
import re
import sys
from difflib import SequenceMatcher
from importlib.machinery import PathFinder
from types import TracebackType
from typing import TYPE_CHECKING, Any, Protocol

from edulaunch.engine.facts import facts_of
from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.interfaces.mistakes import field_facts
from edulaunch.engine.nearest import nearest, nearest_spelling
from edulaunch.engine.packages.absent import absent_module_kind

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index
    from edulaunch.engine.processes.finding import Overlay
    from edulaunch.engine.processes.loader import Loader


class Program(Protocol):
    """The parts of a program that this module needs to find facts about an error."""

    index: Index

    @property
    def loader(self) -> Loader: ...

    @property
    def overlay(self) -> Overlay: ...


ENDED_BY = {
    'Node': 'destroy_node()',
    'LifecycleNode': 'destroy_node()',
    'Publisher': 'destroy()',
    'LifecyclePublisher': 'destroy()',
    'Subscription': 'destroy()',
    'Client': 'destroy()',
    'Service': 'destroy()',
    'Timer': 'destroy()',
    'GuardCondition': 'destroy()',
    'Rate': 'destroy()',
}
"""The method that ends an object of rclpy, by the object's class."""


def with_facts_at(error: BaseException) -> dict[str, Any]:
    """Return facts about `with rclpy.init():`, or about `with node:` if Python names the class of the object (since 3.11).

    Return {} for any other error.
    """
    if '__enter__' not in str(error) and 'context manager' not in str(error):
        return {}
    trace = _innermost(error.__traceback__)
    if trace is None:
        return {}
    if 'rclpy.init(' in linecache.getline(trace.tb_frame.f_code.co_filename, trace.tb_lineno):
        return {'about': 'programs.with-init'}
    found = re.match(r"'(?:[\w.]+\.)?(\w+)' object does not support the \w*? ?context manager protocol", str(error))
    ending = None if found is None else ENDED_BY.get(_kind(found[1], trace))
    return {} if found is None or ending is None else {'about': 'programs.with-entity', 'thing': found[1], 'ending': ending}


def _innermost(trace: TracebackType | None) -> TracebackType | None:
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return trace


def _kind(name: str, trace: TracebackType) -> str:
    """Return the name of the rclpy class from which a class is derived, or '' without such a class.

    If the program has no class with this name, return the name itself.
    """
    known = trace.tb_frame.f_locals.get(name) or trace.tb_frame.f_globals.get(name)
    if not isinstance(known, type):
        return name
    return next((base.__name__ for base in known.__mro__ if base.__module__.startswith('rclpy.')), '')


ENDINGS = ('.so', '.dylib', '.pyd', '.pyx')
"""Endings of compiled modules on Unix, macOS and Windows, and of files for Cython."""
_TARGET = r'(?:pybind11_add_module|nanobind_add_module|[Pp]ython3?_add_library|cython_add_module)\s*\(\s*{name}\b'
_LIBRARY = re.compile(r'(\S+): cannot open shared object file')


def compiled_module(process: Program, name: str) -> str | None:
    """Return the compiled code of a module that Python did not find ('robo/fast.so'), or the line of CMakeLists.txt that builds
    it.

    Return None if there is neither.
    """
    parent, _, leaf = name.rpartition('.')
    if parent:
        folders = list(getattr(process.loader.modules.get(parent), '__path__', ()))
    else:
        folders = process.loader.finder.folders()
    for folder in folders:
        for file in sorted(os.listdir(folder)) if os.path.isdir(folder) else ():
            if file.endswith(ENDINGS) and file.partition('.')[0] == leaf:
                return f'{os.path.basename(folder)}/{file}'
    return _built_by_cmake(process, name.partition('.')[0], leaf)


def missing_library(error: BaseException) -> str | None:
    """Return the native library that the operating system did not find while it loaded a module, or None for another error."""
    found = _LIBRARY.match(str(error))
    return found[1] if found is not None else None


def _built_by_cmake(process: Program, package: str, leaf: str) -> str | None:
    source = process.index.source_folder(package) if package in process.index.packages() else None
    try:
        with open(os.path.join(source or '', 'CMakeLists.txt'), encoding='utf-8', errors='replace') as file:
            text = file.read()
    except OSError:
        return None
    found = re.search(_TARGET.format(name=re.escape(leaf)), text) if source is not None else None
    return None if found is None else f'{package}/CMakeLists.txt:{text.count(chr(10), 0, found.start()) + 1}'


Found = dict[str, Any]
INTERFACE_ENDINGS = ('_msgs', '_srvs', '_interfaces', '_interface', '_msg', '_srv', '_actions')
SPELLING = ('rclpy', 'launch', 'launch_ros', 'tf2_ros', 'tf_transformations')


def error_facts(process: Program, error: BaseException) -> Found:
    """Return the facts of an error, in which `about` is the name of the rule that explains the error.

    Facts that are attached to the error itself take precedence. Return {} if there are no facts.
    """
    carried = facts_of(error)
    if carried:
        return carried
    if type(error) is ModuleNotFoundError and error.name:  # importlib.metadata raises a subclass that is not about modules
        return _module(process, error.name)
    if isinstance(error, ImportError | OSError) and (library := missing_library(error)):
        return {'about': 'programs.library', 'library': library}
    if isinstance(error, ImportError):
        return _hiding(process, error.name) or _imported_name(process, error)
    if found := with_facts_at(error):
        return found
    if isinstance(error, AttributeError):
        return _hiding(process, getattr(error.obj, '__name__', None)) or field_facts(error, current_registry())
    return {}


def _hiding(process: Program, name: Any) -> Found:
    """Return facts about a standard module that a student's file with the same name hides, or {}."""
    own = process.loader.modules.get(name) if name in sys.stdlib_module_names else None
    file = getattr(own, '__file__', None)
    if file is None or file == getattr(PathFinder.find_spec(name), 'origin', None):
        return {}
    return {'about': 'programs.hides-module', 'own_file': file, 'module': name}


def _module(process: Program, name: str) -> Found:
    """Return facts about an unknown module, such as the software that it belongs to, or the nearest name."""
    top = name.partition('.')[0]
    if compiled := compiled_module(process, name):
        return {'about': 'programs.compiled-module', 'module': name, 'compiled': compiled}
    if name != top and _parent_is_there(process, name):
        return (top in process.overlay.interface_packages and _package(process, top)) or _part(process, name)
    if kind := absent_module_kind(top):
        return {'about': 'packages.absent-module', 'module': top, 'belongs_to': kind}
    return _package(process, top) or _unknown_module(process, top)


def _package(process: Program, top: str) -> Found:
    """Return facts about a package whose modules are not installed, or which has only interfaces. Return {} if it does not
    exist.
    """
    if top not in process.index.packages():
        return {}
    if top not in process.overlay.interface_packages:
        return {'about': 'packages.no-module', 'package': top}
    has = [f'{top}.{kind}' for kind in ('msg', 'srv', 'action') if process.overlay.registry.has(top, kind)]
    return {'about': 'messages.other-interfaces', 'package': top, 'interfaces': has}


def _imported_name(process: Program, error: ImportError) -> Found:
    """Return facts about a name that a module does not have: the nearest name, or that two modules import each other."""
    found = re.match("cannot import name '(.+?)' from (partially initialized module )?", str(error))
    if found is None:
        return {}
    if found[2]:
        return {'about': 'programs.import-circle', 'module': error.name}
    name = f'{error.name}.{found[1]}'
    if compiled := compiled_module(process, name):
        return {'about': 'programs.compiled-module', 'module': name, 'compiled': compiled}
    homes = [home for home in current_registry().homes(found[1]) if home.startswith(f'{error.name}.')]
    if homes:  # `from geometry_msgs import Twist`
        return {'about': 'messages.no-interface', 'interface': found[1], 'module': error.name, 'homes': homes}
    module = process.loader.modules.get(error.name or '')
    names = [] if module is None else [name for name in vars(module) if not name.startswith('__')]
    return {
        'about': 'programs.import-name',
        'missing': found[1],
        'module': error.name,
        'near': nearest(found[1], names),
        'known': names if len(names) < 12 else [],
    }


def _parent_is_there(process: Program, name: str) -> bool:
    parent = name.rpartition('.')[0]
    return parent in process.loader.modules or parent in sys.modules


def _is_module(path: str) -> bool:
    return path.endswith('.py') or os.path.isfile(os.path.join(path, '__init__.py'))


def _part(process: Program, name: str) -> Found:
    """Return facts about a missing module of an existing package: the other modules of the package, and the nearest name."""
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
    near = nearest_spelling(leaf, beside)
    return {'about': 'programs.module-part', 'module': name, 'parent': parent, 'near': near, 'known': beside}


def _unknown_module(process: Program, top: str) -> Found:
    known = {*current_registry().packages(), *process.overlay.modules, *SPELLING}
    ending = next((ending for ending in INTERFACE_ENDINGS if top.endswith(ending)), '')
    alike = nearest_spelling if ending else nearest
    near = alike(top.removesuffix(ending), [name.removesuffix(ending) for name in known if name.endswith(ending)])
    sure = near is not None and (ending or _alike(top, near))
    about = 'messages.unknown-package' if ending else 'programs.unknown-module'
    return {'about': about, 'module': top, 'near': f'{near}{ending}' if sure else None}


def _alike(name: str, near: str) -> bool:
    """Return whether two names are nearly equal. A looser match would be wrong, because other projects have similar module
    names.
    """
    return SequenceMatcher(None, name, near).ratio() >= 0.8
