"""Packages whose names are imported when they are first used.

`import launch` must be quick, and a launch file uses a handful of launch's ninety classes. Upstream imports
them all.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any

Exports = dict[str, str]
"""Exported name -> the sub-module (relative to the package) that defines it; '' for a name that is a
sub-module.
"""


def lazy_exports(
    package: str, exports: Exports, absent: Mapping[str, str] | None = None
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Make the `__getattr__` and `__dir__` of a package that loads its `exports` late.

    The sub-modules themselves are attributes too, as they are upstream
    (`launch.actions.timer_action.TimerAction`). A name that is not there gives Python's own AttributeError
    (which `from package import name` turns into ImportError).

    :param absent: names of ROS 2 that are not here, each with what to use in its place; asked for, they are an ImportError.
    """
    modules = {*exports.values(), *(name for name, module in exports.items() if not module)}

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
