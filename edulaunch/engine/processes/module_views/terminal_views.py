"""`select`, `termios`, `fcntl` and `tty` for programs that read keys, whose keyboard is their scripted input.

The module also contains `signal`, whose handlers run where the program waits.
"""

from __future__ import annotations

import errno
import math
import os
import signal
import sys
from collections.abc import Callable
from types import FrameType, ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.frame_owner import is_engine
from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.processes.spec import Signals
from edulaunch.engine.sim import sync
from edulaunch.engine.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process


def make_select(view: ModuleType, process: Process) -> ModuleType:
    """Make `select.select` wait in simulated time. The program's input is ready if a program can read without waiting."""
    import select as real

    def is_input(file: Any) -> bool:
        return file is process.streams.stdin or file == 0 or getattr(file, '_input', None) is process.streams.stdin

    def select(rlist: Any, wlist: Any, xlist: Any, timeout: float | None = None, /) -> tuple[list[Any], list[Any], list[Any]]:
        keyboards, others = [file for file in rlist if is_input(file)], [file for file in rlist if not is_input(file)]
        ready = real.select(others, wlist, xlist, 0) if others or wlist or xlist else ([], [], [])
        if keyboards and process.streams.stdin.wait(0.0 if any(ready) else timeout):
            return keyboards + list(ready[0]), *ready[1:]
        if any(ready) or keyboards:
            return ready
        sync.sleep(timeout or 0.0)
        return real.select(others, wlist, xlist, 0) if others or wlist or xlist else ready

    view.__dict__['select'] = select
    copy_names(view, real)
    return view


def make_termios(view: ModuleType, process: Process) -> ModuleType:
    """Make a `termios` with the attributes of the program's input.

    If the program switches canonical mode off, it reads its input key by key.
    """
    import termios as real

    cooked: list[Any] = [
        real.ICRNL,
        real.OPOST,
        real.CS8,
        real.ICANON | real.ECHO | real.ISIG,
        real.B38400,
        real.B38400,
        [b'\x00'] * real.NCCS,
    ]
    state = {'now': cooked}

    def tcgetattr(fd: Any, /) -> list[Any]:
        now = state['now']
        return [*now[:6], list(now[6])]

    def tcsetattr(fd: Any, when: int, attributes: list[Any], /) -> None:
        state['now'] = [*attributes[:6], list(attributes[6])]
        process.streams.stdin.change_mode(process, attributes[3])

    view.__dict__.update(tcgetattr=tcgetattr, tcsetattr=tcsetattr, tcflush=lambda fd, queue, /: None, tcdrain=lambda fd, /: None)
    copy_names(view, real)
    return view


def make_fcntl(view: ModuleType, process: Process) -> ModuleType:
    """Make `fcntl.fcntl` work on the program's input. If O_NONBLOCK is set, reading does not wait."""
    import fcntl as real

    def fcntl(fd: Any, cmd: int, arg: Any = 0, /) -> Any:
        if fd is not process.streams.stdin and fd not in (0, 1, 2):
            return real.fcntl(fd, cmd, arg)
        if cmd == real.F_SETFL and (fd is process.streams.stdin or fd == 0):
            process.streams.stdin.blocking = not arg & os.O_NONBLOCK
        return 0 if process.streams.stdin.blocking or cmd != real.F_GETFL else os.O_NONBLOCK

    view.__dict__['fcntl'] = fcntl
    copy_names(view, real)
    return view


def make_tty(view: ModuleType, process: Process) -> ModuleType:
    """Make a `tty` with `setraw` and `setcbreak` for the program's input."""
    import tty as real

    def set_mode(clear: int) -> Callable[..., list[Any]]:
        def change(fd: Any, when: int = 2) -> list[Any]:
            termios: Any = process.loader.import_module('termios')
            before: list[Any] = termios.tcgetattr(fd)
            mode = [*before[:3], before[3] & ~clear, *before[4:]]
            termios.tcsetattr(fd, when, mode)
            return before

        return change

    import termios

    by_key = termios.ICANON | termios.ECHO
    view.__dict__.update(setraw=set_mode(by_key | termios.ISIG), setcbreak=set_mode(by_key))
    copy_names(view, real)
    return view


def make_signal(view: ModuleType, process: Process) -> ModuleType:
    """Make `signal.signal` install a handler for this process. The handler is called as handler(signum, frame)."""
    handlers = process.signals.handlers
    installed: dict[int, Any] = {}

    def install(signum: int, handler: Any) -> Any:
        _check(process, signum, handler)
        before = getsignal(signum)
        installed[signum] = handler
        if handler is signal.SIG_DFL and signum == signal.SIGINT:
            handlers[signum] = process.signals.die_at_once  # not Python's own handler, which raises KeyboardInterrupt
        elif handler is signal.SIG_DFL or handler is signal.default_int_handler:
            handlers.pop(signum, None)
        elif handler is signal.SIG_IGN:
            handlers[signum] = lambda number: None
        else:
            handlers[signum] = lambda number: handler(number, _interrupted_frame())
        return before

    def getsignal(signum: int) -> Any:
        return installed.get(signum, signal.default_int_handler if signum == signal.SIGINT else signal.SIG_DFL)

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
    copy_names(view, signal)
    return view


def _timer(process: Process) -> Callable[..., tuple[float, float]]:
    """Return a `setitimer` that works in simulated time."""
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
    """Raise Python's error if the handler cannot be installed."""
    if not (callable(handler) or handler in (signal.SIG_DFL, signal.SIG_IGN)):
        raise TypeError('signal handler must be signal.SIG_IGN, signal.SIG_DFL, or a callable object')
    if current_task() is not process.lifecycle.task:
        raise ValueError('signal only works in main thread of the main interpreter')
    if signum in (Signals.SIGKILL, Signals.SIGSTOP):
        raise OSError(errno.EINVAL, os.strerror(errno.EINVAL))


def _interrupted_frame() -> FrameType | None:
    """Return the innermost frame of the running program outside the engine, or None."""
    frame: FrameType | None = sys._getframe()
    while frame is not None and is_engine(frame.f_code.co_filename):
        frame = frame.f_back
    return frame
