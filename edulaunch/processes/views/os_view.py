"""`os` of a simulated program: its own environment, folder, pid, children and end."""

from __future__ import annotations

import io
import os as real
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.real_machine import FUNCTIONS as REAL_MACHINE
from edulaunch.processes.real_machine import noting
from edulaunch.processes.signals import Signals
from edulaunch.processes.views import copy_names
from edulaunch.processes.views.files_view import FUNCTIONS, PATH, PlainFunction

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

LEFT_OUT = ('fork', 'forkpty', 'register_at_fork')
"""A simulated program cannot be copied by the operating system."""

CPUS = 4
"""Of the simulated machine: pools are as large on every real one."""


class Reader(io.StringIO):
    """What `os.popen` gives: the output of a command; closing it gives the exit status."""

    def __init__(self, text: str, status: int) -> None:
        super().__init__(text)
        self._status = status

    def close(self) -> Any:
        """None for success, else the wait status."""
        super().close()
        return self._status or None


def make(view: ModuleType, process: Process) -> ModuleType:
    """`environ` is the process's own dict; `kill` reaches simulated processes by their simulated pid and nothing else;
    `system` and `popen` are those of `subprocess`; `urandom` repeats.
    """
    chance: list[Any] = []

    def putenv(name: str, value: str) -> None:
        process.env[name] = value

    def urandom(size: int, /) -> bytes:
        if not chance:
            chance.append(process.sim.random(f'{process.name}/urandom'))
        drawn: bytes = chance[0].randbytes(size)
        return drawn

    def getcwd() -> str:
        return process.cwd or real.getcwd()

    def chdir(path: Any) -> None:
        target = real.path.abspath(real.path.join(getcwd(), path))
        real.listdir(target)  # raises what the real one does
        process.cwd = target

    view.__dict__.update(FUNCTIONS, path=PATH, **_noted(process), **_files(process), **_commands(process))
    view.__dict__.update(
        environ=process.env,
        getenv=lambda name, default=None: process.env.get(name, default),
        putenv=putenv,
        unsetenv=lambda name: process.env.pop(name, None),
        getpid=lambda: process.pid,
        getppid=lambda: 1000,
        kill=lambda pid, signum, /: _kill(process, pid, signum),
        _exit=lambda status: process.exit_now(status & 0xFF),
        abort=lambda: process.end_by(Signals.SIGABRT),
        getcwd=PlainFunction(getcwd),
        chdir=chdir,
        cpu_count=lambda: CPUS,
        process_cpu_count=lambda: CPUS,
        urandom=urandom,
    )
    copy_names(view, real)
    for name in LEFT_OUT:
        view.__dict__.pop(name, None)
    return view


def _noted(process: Process) -> dict[str, Any]:
    """What tells of the real machine: the recording says that it was asked."""
    return {
        name: PlainFunction(noting(process, f'os.{name}', getattr(real, name))) for name in REAL_MACHINE if hasattr(real, name)
    }


def _files(process: Process) -> dict[str, Any]:
    """The numbers 0, 1 and 2 are the process's own streams."""

    def read(fd: int, length: int, /) -> bytes:
        return process.stdin.read1(length).encode() if fd == 0 else real.read(fd, length)

    def write(fd: int, data: Any, /) -> int:
        if fd not in (1, 2):
            return real.write(fd, data)
        return (process.stdout if fd == 1 else process.stderr).buffer.write(data)

    def get_terminal_size(fd: int = 1, /) -> Any:
        return real.terminal_size(process.stdin.terminal_size())

    def isatty(fd: int, /) -> bool:
        if fd not in (0, 1, 2):
            return real.isatty(fd)
        return bool(process.stdin.isatty() if fd == 0 else process.stdout.isatty())

    return {'read': read, 'write': write, 'get_terminal_size': get_terminal_size, 'isatty': isatty}


def _commands(process: Process) -> dict[str, Any]:
    """Shell lines, as the process's `subprocess` runs them."""

    def run(command: str, **options: Any) -> Any:
        subprocess: Any = process.loader.import_module('subprocess')
        return subprocess.run(command, shell=True, **options)

    def status(code: int) -> int:
        return code << 8 if code >= 0 else -code

    def popen(cmd: str, mode: str = 'r', buffering: int = -1) -> Reader:
        done = run(cmd, text=True, stdout=-1)
        return Reader(done.stdout, status(done.returncode))

    return {'system': lambda command: status(run(command).returncode), 'popen': popen}


def _kill(process: Process, pid: int, signum: int) -> None:
    if pid == process.pid:
        process.send_signal(signum)
        return
    for other in process.host.processes:
        if other.pid == pid:
            other.send_signal(signum)
            return
    raise ProcessLookupError(3, 'No such process')
