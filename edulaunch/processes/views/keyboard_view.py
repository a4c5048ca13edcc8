"""`select`, `termios` and `tty` for programs that read keys: the keyboard is the program's scripted input."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.sim import sync

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def make_select(view: ModuleType, process: Process) -> ModuleType:
    """`select.select` waits in simulated time; the program's input is ready while there is something left to read."""
    import select as real

    def is_input(file: Any) -> bool:
        return file is process.stdin or file == 0 or getattr(file, '_input', None) is process.stdin

    def select(rlist: Any, wlist: Any, xlist: Any, timeout: float | None = None, /) -> tuple[list[Any], list[Any], list[Any]]:
        keyboards, others = [file for file in rlist if is_input(file)], [file for file in rlist if not is_input(file)]
        ready = real.select(others, wlist, xlist, 0) if others or wlist or xlist else ([], [], [])
        if keyboards and process.stdin.wait(0.0 if any(ready) else timeout):
            return keyboards + list(ready[0]), *ready[1:]
        if any(ready) or keyboards:
            return ready
        sync.sleep(timeout or 0.0)
        return real.select(others, wlist, xlist, 0) if others or wlist or xlist else ready

    view.__dict__['select'] = select
    copy_names(view, real)
    return view


def make_termios(view: ModuleType, process: Process) -> ModuleType:
    """The attributes of the program's input; leaving canonical mode makes it a keyboard that is read key by key."""
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
        process.stdin.change_mode(process, attributes[3])

    view.__dict__.update(tcgetattr=tcgetattr, tcsetattr=tcsetattr, tcflush=lambda fd, queue, /: None, tcdrain=lambda fd, /: None)
    copy_names(view, real)
    return view


def make_fcntl(view: ModuleType, process: Process) -> ModuleType:
    """`fcntl.fcntl` on the program's input: reading does not wait after O_NONBLOCK."""
    import fcntl as real
    import os

    def fcntl(fd: Any, cmd: int, arg: Any = 0, /) -> Any:
        if fd is not process.stdin and fd not in (0, 1, 2):
            return real.fcntl(fd, cmd, arg)
        if cmd == real.F_SETFL and (fd is process.stdin or fd == 0):
            process.stdin.blocking = not arg & os.O_NONBLOCK
        return 0 if process.stdin.blocking or cmd != real.F_GETFL else os.O_NONBLOCK

    view.__dict__['fcntl'] = fcntl
    copy_names(view, real)
    return view


def make_tty(view: ModuleType, process: Process) -> ModuleType:
    """`setraw` and `setcbreak` for the program's input."""
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
