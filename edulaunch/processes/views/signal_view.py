"""`signal` of a simulated program: handlers run where the program waits."""

from __future__ import annotations

import errno
import math
import os
import signal as real
import sys
from collections.abc import Callable
from types import FrameType, ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.signals import Signals
from edulaunch.processes.views import copy_names
from edulaunch.processes.whose_code import is_engine
from edulaunch.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def make(view: ModuleType, process: Process) -> ModuleType:
    """`signal.signal` installs a handler for this process; it is called as handler(signum, frame)."""
    installed: dict[int, Any] = {}

    def install(signum: int, handler: Any) -> Any:
        _check(process, signum, handler)
        before = getsignal(signum)
        installed[signum] = handler
        if handler is real.SIG_DFL and signum == real.SIGINT:
            process.signal_handlers[signum] = process.die_at_once  # not Python's own handler, which raises KeyboardInterrupt
        elif handler is real.SIG_DFL or handler is real.default_int_handler:
            process.signal_handlers.pop(signum, None)
        elif handler is real.SIG_IGN:
            process.signal_handlers[signum] = lambda number: None
        else:
            process.signal_handlers[signum] = lambda number: handler(number, _interrupted_frame())
        return before

    def getsignal(signum: int) -> Any:
        return installed.get(signum, real.default_int_handler if signum == real.SIGINT else real.SIG_DFL)

    setitimer = _timer(process)
    view.__dict__.update(
        Signals.__members__,
        Signals=Signals,
        setitimer=setitimer,
        alarm=lambda seconds, /: math.ceil(setitimer(0, seconds)[0]),
        signal=install,
        pause=lambda: current_task().park(),
        raise_signal=process.send_signal,
        getsignal=getsignal,
    )
    copy_names(view, real)
    return view


def _timer(process: Process) -> Callable[..., tuple[float, float]]:
    """`setitimer` in simulated time."""
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
            process.send_signal(Signals.SIGALRM)

        alarm[:] = [sim.schedule(sim.now_ns + round(seconds * 1e9), ring), interval] if seconds else []
        return before

    return setitimer


def _check(process: Process, signum: int, handler: Any) -> None:
    """Raise what Python raises for a handler that cannot be installed."""
    if not (callable(handler) or handler in (real.SIG_DFL, real.SIG_IGN)):
        raise TypeError('signal handler must be signal.SIG_IGN, signal.SIG_DFL, or a callable object')
    if current_task() is not process.task:
        raise ValueError('signal only works in main thread of the main interpreter')
    if signum in (Signals.SIGKILL, Signals.SIGSTOP):
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL))


def _interrupted_frame() -> FrameType | None:
    """Where the program stood: its innermost frame that is none of the engine's."""
    frame: FrameType | None = sys._getframe()
    while frame is not None and is_engine(frame.f_code.co_filename):
        frame = frame.f_back
    return frame
