"""Names that a module of ROS 2 contains only because it imports them, and that programs import from that module.

Editors insert `from rclpy.node import Publisher` automatically, and this import works with ROS 2. Here a module imports only what
it needs, on first use. `passed_on.txt` lists the other names of the module in ROS 2, which are loaded on request.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any


def passed_on(module: str) -> Callable[[str], Any]:
    """Return the `__getattr__` of a module, which loads these names on request."""

    def __getattr__(name: str) -> Any:
        if name.startswith('__') or name not in homes_of(module):
            raise AttributeError(f'module {module!r} has no attribute {name!r}')
        home, original = homes_of(module)[name]
        found = import_module(home)
        value = getattr(found, original) if original else found
        setattr(sys.modules[module], name, value)
        return value

    return __getattr__


def homes_of(module: str) -> dict[str, tuple[str, str]]:
    """Return the defining module and the original name for each name that a module passes on. The original name is '' for a
    module.
    """
    return _tables()[module]


@cache
def _tables() -> dict[str, dict[str, tuple[str, str]]]:
    tables: dict[str, dict[str, tuple[str, str]]] = {}
    with open(os.path.join(os.path.dirname(__file__), 'passed_on.txt'), encoding='utf-8') as file:
        for line in file:
            if not line.startswith(('#', ' ')):
                table = tables[line.strip()] = {}
            elif line.startswith(' '):
                home, _, taken = line.strip().partition(':')
                for entry in taken.split() or [f'{home.rpartition(".")[2]}=']:
                    name, renamed, original = entry.partition('=')
                    table[name] = home, original if renamed else name
    return tables
