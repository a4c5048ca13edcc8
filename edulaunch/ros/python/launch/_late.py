"""Names of a package that are imported on first use (PEP 562).

A launch file uses a few of launch's ninety classes, each of which has its own module as in ROS 2. Importing all of them takes 30
ms. So the `__init__` of a package with many modules lists them twice. Editors and type checkers read plain imports below
`TYPE_CHECKING`, and :func:`late_names` reads a table. A test checks that both lists are equal.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from typing import Any


def late_names(
    package: str,
    names: Mapping[str, str],
    *,
    modules: Iterable[str] = (),
    attributes: Iterable[str] = (),
    eager: Iterable[str] = (),
    absent: Mapping[str, str] | None = None,
) -> tuple[list[str], Callable[[str], Any], Callable[[], list[str]]]:
    """Create the `__all__`, `__getattr__` and `__dir__` of a package.

    As in ROS 2, the modules of the package are also attributes without an import (`launch.actions.timer_action.TimerAction`).

    :param package: the name of the package.
    :param names: the exported names, each with the module of the package that defines it.
    :param modules: the modules of the package that are exported as well.
    :param attributes: the modules that are attributes, but are not exported.
    :param eager: the objects that the package has already imported. They must include each function that has the same name
        as its module. Otherwise, importing the module would replace the function with the module.
    :param absent: names of ROS 2 that edulaunch does not have, each with its replacement; importing such a name raises
        ImportError.
    """
    exported = [*modules, *eager, *names]
    known = {*modules, *attributes, *names.values()}

    def __getattr__(name: str) -> Any:
        if name in names:
            value = getattr(import_module(f'{package}.{names[name]}'), name)
        elif name in known:
            value = import_module(f'{package}.{name}')
        elif absent and name in absent:
            raise ImportError(
                f'cannot import name {name!r} from {package!r}\n  help: it is not part of edulaunch: {absent[name]}'
            )
        else:
            raise AttributeError(f'module {package!r} has no attribute {name!r}')
        setattr(sys.modules[package], name, value)
        return value

    return exported, __getattr__, lambda: sorted(exported)
