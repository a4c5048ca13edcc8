"""Find the modules of the names that launch files import, and the arguments of the classes."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from typing import Any

from edulaunch.engine.nearest import nearest
from edulaunch.errors import ForeignRosError
from edulaunch.ros.sourcing import source

_PLACES = {
    'launch': (
        '. .actions .conditions .substitutions .event_handlers .events .events.process .launch_description_sources .descriptions'
    ),
    'launch_ros': '.actions .substitutions .descriptions .parameter_descriptions .event_handlers .events.lifecycle',
    'ament_index_python': '.packages',
}
MODULES = tuple((package + place).rstrip('.') for package, places in _PLACES.items() for place in places.split())
STANDARD = ('os', 'sys', 'pathlib', 'math', 'json', 'yaml', 'xacro', 'time', 'random')


@cache
def names_in(module: str) -> list[str]:
    """Return the names that a module exports, or the names that it defines if it has no `__all__`.

    Return an empty list if the module cannot be imported, because the reader of a report may not have sourced ROS 2.
    """
    try:
        source()
        found = import_module(module)
    except (ImportError, ForeignRosError):
        return []
    defined = [name for name, value in vars(found).items() if getattr(value, '__module__', None) == module and name[0] != '_']
    return list(getattr(found, '__all__', defined))


def home_of(name: str) -> str | None:
    """Return the module of launch that exports a name, or None if no module exports it."""
    return next((one for one in MODULES if name in names_in(one) and f'{one}.{name}' not in MODULES), None)


def class_named(name: str) -> Any:
    """Return the exported class of this name, or None if no module exports it."""
    home = home_of(name)
    return getattr(import_module(home), name) if home is not None else None


def import_line(name: str | None) -> str | None:
    """Return the import statement for a name, or None if no module exports the name."""
    if name in STANDARD:
        return f'import {name}'
    home = home_of(name) if name else None
    return f'from {home} import {name}' if home is not None else None


def nearest_anywhere(name: str) -> str | None:
    """Return the exported name of any module that is most similar to `name`, or None if no name is similar."""
    return nearest(name, [known for module in MODULES for known in names_in(module)])


def keywords_of(cls: type) -> list[str]:
    """Return the keyword arguments of a class's constructor. Include inherited arguments if the constructor passes `**kwargs`
    to its base.
    """
    found: list[str] = []
    for base in cls.__mro__:
        code = getattr(base.__dict__.get('__init__'), '__code__', None)
        if code is None:
            continue
        count = code.co_argcount + code.co_kwonlyargcount
        found += [name for name in code.co_varnames[1:count] if name not in found]
        if not code.co_flags & 0x08:  # without **kwargs, the constructor passes no arguments to its base class
            break
    return found
