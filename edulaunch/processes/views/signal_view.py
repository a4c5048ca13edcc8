"""`signal` of a simulated program: handlers run where the program waits."""
from __future__ import annotations

import math
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

    alarm: list[Any] = []

    def setitimer(which: int, seconds: float, interval: float = 0.0, /) -> tuple[float, float]:
        sim = process.sim
        before = (0.0, 0.0)
        if alarm and alarm[0][3] is not None:
            before = ((alarm[0][0] - sim.now_ns) / 1e9, alarm[1])
            sim.cancel(alarm[0])

        def ring() -> None:
            alarm.clear()
            if interval:
                setitimer(which, interval, interval)
            process.send_signal(real.SIGALRM)

        alarm[:] = [sim.schedule(sim.now_ns + round(seconds * 1e9), ring), interval] if seconds else []
        return before

    def set_alarm(seconds: int, /) -> int:
        return math.ceil(setitimer(0, seconds)[0])

    view.__dict__.update(
        setitimer=setitimer, alarm=set_alarm,
        signal=install, pause=pause, raise_signal=process.send_signal,
        getsignal=lambda signum: installed.get(signum, real.default_int_handler if signum == real.SIGINT else real.SIG_DFL))
    copy_names(view, real)
    return view
