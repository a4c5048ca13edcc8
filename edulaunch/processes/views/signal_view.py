"""`signal` of a simulated program: handlers run where the program waits."""
from __future__ import annotations

import signal as real
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def make(view: ModuleType, process: Process) -> ModuleType:
    """`signal.signal` installs a handler for this process; it is called as handler(signum, None)."""
    installed: dict[int, Any] = {}

    def install(signum: int, handler: Any) -> Any:
        before = installed.get(signum, real.default_int_handler if signum == real.SIGINT else real.SIG_DFL)
        installed[signum] = handler
        if handler is real.SIG_DFL or handler is real.default_int_handler:
            process.signal_handlers.pop(signum, None)
        elif handler is real.SIG_IGN:
            process.signal_handlers[signum] = lambda number: None
        else:
            process.signal_handlers[signum] = lambda number: handler(number, None)
        return before

    def pause() -> None:
        current_task().park()

    view.__dict__.update(
        signal=install, pause=pause, raise_signal=process.send_signal,
        getsignal=lambda signum: installed.get(signum, real.default_int_handler if signum == real.SIGINT else real.SIG_DFL))
    copy_names(view, real)
    return view
