"""Names that a module of ROS 2 has only because it imports them, and that programs import from there all the same.

`from rclpy.node import Publisher` is what editors write by themselves, and it works with ROS 2. Here a module imports what
it needs, late; the other names that it has there are listed beside it and loaded when they are asked for.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from typing import Any


def passed_on(module: str, names: dict[str, str]) -> Callable[[str], Any]:
    """Make the `__getattr__` of a module.

    :param names: for each module that ROS 2's module imports from, the names that it takes, with spaces between; `a=b` for
        what is called b at its home. No names for a module that is imported as such.
    """
    homes: dict[str, tuple[str, str]] = {}
    for home, taken in names.items():
        for entry in taken.split() or [f'{home.rpartition(".")[2]}=']:
            name, renamed, original = entry.partition('=')
            homes[name] = home, original if renamed else name

    def __getattr__(name: str) -> Any:
        if name not in homes:
            raise AttributeError(f'module {module!r} has no attribute {name!r}')
        home, original = homes[name]
        found = import_module(home)
        value = getattr(found, original) if original else found
        setattr(sys.modules[module], name, value)
        return value

    __getattr__.names = list(homes)  # type: ignore[attr-defined]  # what there is to ask for
    return __getattr__
