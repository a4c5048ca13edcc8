"""`multiprocessing`: the simulated machine cannot copy a program. Importing it does no harm, using it tells what to use."""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.processes.views.os_view import CPUS

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

NAMES = (
    'Process',
    'Pool',
    'Queue',
    'SimpleQueue',
    'JoinableQueue',
    'Pipe',
    'Manager',
    'Value',
    'Array',
    'RawValue',
    'RawArray',
    'Lock',
    'RLock',
    'Event',
    'Condition',
    'Semaphore',
    'BoundedSemaphore',
    'Barrier',
    'get_context',
)


def make(view: ModuleType, process: Process) -> ModuleType:
    """See above; `cpu_count` is the simulated machine's."""
    import multiprocessing as real

    for name in NAMES:
        view.__dict__[name] = _refusal(name, process)
    view.__dict__.update(cpu_count=lambda: CPUS, set_start_method=lambda method, force=False: None, freeze_support=lambda: None)
    copy_names(view, real)
    return view


def _refusal(name: str, process: Process) -> type:
    """What raises when it is called; a class, since programs derive from `multiprocessing.Process`."""

    class Refused:
        """Only its name is there."""

        def __init__(self, *_: Any, **__: Any) -> None:
            error: Any = RuntimeError(f'multiprocessing.{name} cannot be used: the simulation cannot copy a running program')
            error.edulaunch_hint = (
                f'{process.name} wants another process; in place of it use threading '
                '(Thread, queue.Queue, ThreadPoolExecutor), which works in simulated time'
            )
            raise error

    Refused.__name__ = Refused.__qualname__ = name
    return Refused
