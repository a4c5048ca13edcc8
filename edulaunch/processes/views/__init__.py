"""Views: what standard modules look like from inside a simulated program.

Each is a module of its own per process, with the real module's names, except for those that would leave the simulation:
the clock, chance, threads, the process and its environment.
"""
from __future__ import annotations

from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

VIEWS = {
    'time': 'time_view',
    'random': 'random_view',
    'sys': 'sys_view',
    'os': 'os_view',
    'signal': 'signal_view',
    'threading': 'threading_view',
    'queue': 'queue_view',
    'datetime': 'datetime_view',
    'uuid': 'uuid_view',
}


def make_view(name: str, process: Process) -> ModuleType | None:
    """The view of a standard module for one process, or None when that module needs none."""
    place = VIEWS.get(name)
    if place is None:
        return None
    view = ModuleType(name)
    view.__dict__['__edulaunch_view__'] = True
    made: ModuleType = import_module(f'edulaunch.processes.views.{place}').make(view, process)
    return made


def copy_names(view: ModuleType, real: ModuleType) -> None:
    """Give the view all names of the real module that it does not have yet."""
    for name, value in real.__dict__.items():
        if name not in view.__dict__ or name in ('__doc__', '__file__'):
            view.__dict__[name] = value
