"""Views: what standard modules look like from inside a simulated program.

Each is a module of its own per process, with the real module's names, except for those that would leave the simulation:
the clock, chance, threads, the process and its environment.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

VIEWS = {
    '_tkinter': 'refused_view.make_tkinter',
    'asyncio': 'asyncio_view.make',
    'atexit': 'atexit_view.make',
    'builtins': 'builtins_view.make',
    'datetime': 'datetime_view.make',
    'fcntl': 'keyboard_view.make_fcntl',
    'importlib': 'importlib_view.make',
    'importlib.metadata': 'refused_view.make_metadata',
    'importlib.resources': 'importlib_view.make_resources',
    'importlib.util': 'importlib_view.make_util',
    'io': 'files_view.make_io',
    'multiprocessing': 'refused_view.make_multiprocessing',
    'numpy': 'numpy_view.make',
    'numpy.random': 'numpy_view.make_random',
    'os': 'os_view.make',
    'os.path': 'files_view.make_path',
    'posixpath': 'files_view.make_path',
    'pickle': 'pickle_view.make',
    'queue': 'queue_view.make',
    'random': 'random_view.make',
    'select': 'keyboard_view.make_select',
    'signal': 'signal_view.make',
    'subprocess': 'subprocess_view.make',
    'sys': 'sys_view.make',
    'termios': 'keyboard_view.make_termios',
    'threading': 'threading_view.make',
    'time': 'time_view.make',
    'tty': 'keyboard_view.make_tty',
    'turtle': 'refused_view.make_turtle',
    'uuid': 'uuid_view.make',
}
"""Module name -> what makes its view, called as make(new module, process)."""


def _standard(name: str) -> Callable[[], tuple[str, bool]]:
    def place() -> tuple[str, bool]:
        spec = PathFinder.find_spec(name)
        if spec is None or spec.origin is None:
            raise ModuleNotFoundError(f'No module named {name!r}', name=name)
        return spec.origin, spec.submodule_search_locations is not None

    return place


PRIVATE_COPIES = {
    name: _standard(name)
    for name in (
        'argparse',
        'cmd',
        'concurrent',
        'contextlib',
        'fileinput',
        'getpass',
        'glob',
        'inspect',
        'logging',
        'optparse',
        'pathlib',
        'sched',
        'secrets',
        'shutil',
        'tkinter',
        'traceback',
    )
}
"""Standard packages that every program executes for itself, so that they use its views of arguments, time, threads and streams:
what gives the file of each, and whether it is a package."""


def make_view(name: str, process: Process) -> ModuleType | None:
    """The view of a standard module for one process, or None when that module needs none."""
    place = VIEWS.get(name)
    if place is None:
        return None
    view = ModuleType(name)
    view.__dict__['__edulaunch_view__'] = True
    file, _, function = place.partition('.')
    made: ModuleType = getattr(import_module(f'edulaunch.processes.views.{file}'), function)(view, process)
    return made


def copy_names(view: ModuleType, real: ModuleType) -> None:
    """Give the view all names of the real module that it does not have yet."""
    own = dict(view.__dict__)
    view.__dict__.update(real.__dict__)
    view.__dict__.update(own, __doc__=real.__doc__)
    if hasattr(real, '__file__'):
        view.__dict__['__file__'] = real.__file__
