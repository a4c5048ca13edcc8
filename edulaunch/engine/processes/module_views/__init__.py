"""Views: the versions of standard modules that simulated programs use.

A view is a separate module for each process, with the names of the real module. Names that would use the real machine are
replaced: the clock, random numbers, threads, the process and its environment.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType

VIEWS = {
    '_tkinter': 'refused_view.make_tkinter',
    'asyncio': 'asyncio_view.make_asyncio',
    'atexit': 'os_views.make_atexit',
    'builtins': 'import_views.make_builtins',
    'datetime': 'time_views.make_datetime',
    'fcntl': 'terminal_views.make_fcntl',
    'importlib': 'import_views.make_importlib',
    'importlib.metadata': 'refused_view.make_metadata',
    'importlib.resources': 'import_views.make_resources',
    'importlib.util': 'import_views.make_util',
    'io': 'file_views.make_io',
    'multiprocessing': 'refused_view.make_multiprocessing',
    'numpy': 'chance_views.make_numpy',
    'numpy.random': 'chance_views.make_numpy_random',
    'os': 'os_views.make_os',
    'os.path': 'file_views.make_path',
    'posixpath': 'file_views.make_path',
    'pickle': 'import_views.make_pickle',
    'queue': 'thread_views.make_queue',
    'random': 'chance_views.make_random',
    'select': 'terminal_views.make_select',
    'signal': 'terminal_views.make_signal',
    'subprocess': 'subprocess_view.make_subprocess',
    'sys': 'os_views.make_sys',
    'termios': 'terminal_views.make_termios',
    'threading': 'thread_views.make_threading',
    'time': 'time_views.make_time',
    'tty': 'terminal_views.make_tty',
    'turtle': 'refused_view.make_turtle',
    'uuid': 'chance_views.make_uuid',
}
"""Module name -> the function that makes its view, called as make(new module, process)."""


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
        'tempfile',
        'tkinter',
        'traceback',
    )
}
"""Standard packages that every program executes for itself, so that they use its views of arguments, time, threads and streams.
Each has a function that returns the file of a module, and whether the module is a package.
"""


def make_view(name: str, process: object) -> ModuleType | None:
    """Return the view of a standard module for one process, or None for a module that needs no view."""
    place = VIEWS.get(name)
    if place is None:
        return None
    view = ModuleType(name)
    view.__dict__['__edulaunch_view__'] = True
    file, _, function = place.partition('.')
    made: ModuleType = getattr(import_module(f'edulaunch.engine.processes.module_views.{file}'), function)(view, process)
    return made


def copy_names(view: ModuleType, real: ModuleType) -> None:
    """Copy all names of the real module that the view does not have yet."""
    own = dict(view.__dict__)
    view.__dict__.update(real.__dict__)
    view.__dict__.update(own, __doc__=real.__doc__)
    if hasattr(real, '__file__'):
        view.__dict__['__file__'] = real.__file__
