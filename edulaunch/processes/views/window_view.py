"""`tkinter` and `turtle`: the simulated machine has no screen.

Many a student's editor has imported something from `turtle` by accident, so both can be imported; opening a window fails as it
does on a machine without a display.
"""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

NO_DISPLAY = 'no display name and no $DISPLAY environment variable'


def make_tkinter(view: ModuleType, process: Process) -> ModuleType:
    """`_tkinter`, on which the whole of `tkinter` stands: opening a window raises `TclError`."""
    import _tkinter as real

    def create(*_: Any, **__: Any) -> Any:
        raise _no_display(process, real.TclError)

    view.__dict__['create'] = create
    copy_names(view, real)
    return view


class TurtleView(ModuleType):
    """Every public name is there; whatever is called tells that there is no screen."""

    def __init__(self, process: Process) -> None:
        super().__init__('turtle')
        self.__edulaunch_view__ = True
        self.__all__: list[str] = []
        self._process = process

    def __getattr__(self, name: str) -> Any:
        if name.startswith('_'):
            raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}')
        process = self._process

        class NeedsScreen:
            """A function or class of `turtle`."""

            def __init__(self, *_: Any, **__: Any) -> None:
                raise _no_display(process, RuntimeError)

        NeedsScreen.__name__ = NeedsScreen.__qualname__ = name
        setattr(self, name, NeedsScreen)
        return NeedsScreen


def make_turtle(view: ModuleType, process: Process) -> ModuleType:
    """See `TurtleView`."""
    return TurtleView(process)


def _no_display(process: Process, kind: type[Exception]) -> Exception:
    error: Any = kind(NO_DISPLAY)
    error.edulaunch_hint = (
        f'{process.name} opens a window; the simulation has no screen. '
        'turtlesim is drawn by edulaunch itself, other windows cannot be shown'
    )
    return error  # type: ignore[no-any-return]
