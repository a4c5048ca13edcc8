"""`pickle` that finds the classes of the program's own modules."""

from __future__ import annotations

import datetime
from importlib.machinery import PathFinder
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.finding import Found

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

NAMES = ('dump', 'dumps', 'load', 'loads', 'Pickler', 'Unpickler')


def make(view: ModuleType, process: Process) -> ModuleType:
    """The standard module, executed privately, with its functions in Python: those in C look for classes in modules that all
    programs share.
    """
    spec = PathFinder.find_spec('pickle')
    assert spec is not None and spec.origin is not None
    made: Any = process.loader.load_file('pickle', Found(spec.origin, False))
    made._Pickler = _pickler_class(made)
    made.__dict__.update({name: made.__dict__[f'_{name}'] for name in NAMES}, __edulaunch_view__=True)
    return made  # type: ignore[no-any-return]


def _pickler_class(pickle: Any) -> type:
    class Pickler(pickle._Pickler):  # type: ignore[misc]
        """As `pickle.Pickler`. The real `datetime` and `date` are found under their names again as the program's."""

        def save_global(self, obj: Any, name: str | None = None) -> None:
            """Write a class or function by name."""
            if obj is not datetime.datetime and obj is not datetime.date:
                super().save_global(obj, name)
                return
            if self.proto >= 4:
                self.save('datetime')
                self.save(obj.__name__)
                self.write(pickle.STACK_GLOBAL)
            else:
                self.write(pickle.GLOBAL + f'datetime\n{obj.__name__}\n'.encode())
            self.memoize(obj)

    return Pickler
