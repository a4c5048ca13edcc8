"""Modules that the simulated machine does not have.

Programs can import these modules, because many programs import them without need. Using them raises an error that suggests a
replacement.
"""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.processes.module_views.os_views import CPUS

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

NO_COPY = 'multiprocessing.{} cannot be used: the simulation cannot copy a running program'
NO_DISPLAY = 'no display name and no $DISPLAY environment variable'
THREADS, SCREEN, UNBUILT = 'programs.multiprocessing', 'programs.window', 'packages.not-built'
LOCKS = 'Lock RLock Event Condition Semaphore BoundedSemaphore Barrier'
PROCESSES = f'Process Pool Queue SimpleQueue JoinableQueue Pipe Manager Value Array RawValue RawArray {LOCKS} get_context'.split()


def _refused(name: str, kind: type[Exception], text: str, about: str) -> Any:
    """Return a class that raises an error when it is called. It is a class because some programs derive from it."""

    class Refused:
        """A class that cannot be instantiated."""

        def __init__(self, *_: Any, **__: Any) -> None:
            raise with_facts(kind(text.format(name)), about, wanted=name)

    Refused.__name__ = Refused.__qualname__ = name
    return Refused


def make_multiprocessing(view: ModuleType, process: Process) -> ModuleType:
    """Make a `multiprocessing` that rejects everything that would start another process or share data with it."""
    import multiprocessing as real

    view.__dict__.update({name: _refused(name, RuntimeError, NO_COPY, THREADS) for name in PROCESSES})
    view.__dict__.update(cpu_count=lambda: CPUS, set_start_method=lambda method, force=False: None, freeze_support=lambda: None)
    copy_names(view, real)
    return view


def make_tkinter(view: ModuleType, process: Process) -> ModuleType:
    """Make a `_tkinter` in which opening a window raises `TclError`. All of `tkinter` uses this module."""
    import _tkinter as real

    view.__dict__['create'] = _refused('create', real.TclError, NO_DISPLAY, SCREEN)
    copy_names(view, real)
    return view


class TurtleView(ModuleType):
    """A view of `turtle` in which every public name exists, because editors sometimes import one of these names by accident."""

    def __init__(self) -> None:
        super().__init__('turtle')
        self.__edulaunch_view__ = True
        self.__all__: list[str] = []

    def __getattr__(self, name: str) -> Any:
        if name.startswith('_'):
            raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}')
        self.__dict__[name] = made = _refused(name, RuntimeError, NO_DISPLAY, SCREEN)
        return made


def make_turtle(view: ModuleType, process: Process) -> ModuleType:
    """Return a :class:`TurtleView` of the module."""
    return TurtleView()


def make_metadata(view: ModuleType, process: Process) -> ModuleType:
    """Make an `importlib.metadata` with the distributions of Python. It does not contain packages of the workspace."""
    import importlib.metadata as real

    def of(ask: Callable[[str], Any]) -> Callable[[str], Any]:
        def asked(distribution_name: str) -> Any:
            package = distribution_name.replace('-', '_')
            if process.index.share(package) is not None and process.index.contents(package) is not None:
                _refused(distribution_name, real.PackageNotFoundError, '{}', UNBUILT)()
            return ask(distribution_name)

        return asked

    names = ('distribution', 'files', 'metadata', 'requires', 'version')
    view.__dict__.update({name: of(getattr(real, name)) for name in names})
    copy_names(view, real)
    return view
