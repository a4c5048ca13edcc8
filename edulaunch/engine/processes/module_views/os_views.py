"""`os`, `sys` and `atexit` of a simulated program, with the program's own environment, folder, pid, children, arguments, streams,
modules and end.
"""

from __future__ import annotations

import io
import os
import sys
from collections import ChainMap
from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar

from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.processes.module_views.file_views import FUNCTIONS, PATH, PlainFunction
from edulaunch.engine.processes.real_machine import FUNCTIONS as REAL_MACHINE
from edulaunch.engine.processes.real_machine import noting
from edulaunch.engine.processes.spec import Signals

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

LEFT_OUT = ('fork', 'forkpty', 'register_at_fork')
"""A simulated program cannot be copied by the operating system."""

EXEC = tuple(f'exec{form}' for form in ('l', 'le', 'lp', 'lpe', 'v', 've', 'vp', 'vpe'))

CPUS = 4
"""The number of processors of the simulated machine, so that pools have the same size on every real one."""


class Reader(io.StringIO):
    """The result of `os.popen`: the output of a command, with a method `close` that returns the exit status."""

    def __init__(self, text: str, status: int) -> None:
        super().__init__(text)
        self._status = status

    def close(self) -> Any:
        """Close the stream. Return None for success, otherwise the wait status."""
        super().close()
        return self._status or None


def make_os(view: ModuleType, process: Process) -> ModuleType:
    """Give the view its own `environ`, and a `urandom` that returns the same bytes in each run. Return the view.

    `kill` reaches only simulated processes, by their simulated pid. `system` and `popen` use the view of `subprocess`.
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
        return process.cwd or os.getcwd()

    def chdir(path: Any) -> None:
        target = os.path.abspath(os.path.join(getcwd(), path))
        os.listdir(target)  # raises the same errors as os.chdir
        process.cwd = target

    view.__dict__.update(FUNCTIONS, path=PATH, **_recorded_reads(process), **_files(process), **_commands(process))
    view.__dict__.update(
        environ=process.env,
        getenv=lambda name, default=None: process.env.get(name, default),
        putenv=putenv,
        unsetenv=lambda name: process.env.pop(name, None),
        getpid=lambda: process.pid,
        getppid=lambda: 1000,
        kill=lambda pid, signum, /: _kill(process, pid, signum),
        getpgid=lambda pid, /: pid or process.pid,
        getpgrp=lambda: process.pid,
        killpg=lambda group, signum, /: _kill_group(process, group or process.pid, signum),
        **dict.fromkeys(('setpgid', 'setpgrp', 'setsid'), lambda *_: None),
        _exit=lambda status: process.lifecycle.exit_now(status & 0xFF),
        abort=lambda: process.lifecycle.exit_now(-Signals.SIGABRT),
        getcwd=PlainFunction(getcwd),
        chdir=chdir,
        cpu_count=lambda: CPUS,
        process_cpu_count=lambda: CPUS,
        urandom=urandom,
        **{name: _exec(process, name) for name in EXEC},
    )
    copy_names(view, os)
    for name in LEFT_OUT:
        view.__dict__.pop(name, None)
    return view


def _recorded_reads(process: Process) -> dict[str, Any]:
    """Return functions that record that the program has asked for a fact about the real machine."""
    return {name: PlainFunction(noting(process, f'os.{name}', getattr(os, name))) for name in REAL_MACHINE if hasattr(os, name)}


def _files(process: Process) -> dict[str, Any]:
    """Return functions for file descriptors, in which 0, 1 and 2 are the process's own streams."""

    def read(fd: int, length: int, /) -> bytes:
        return process.streams.stdin.read1(length).encode() if fd == 0 else os.read(fd, length)

    def write(fd: int, data: Any, /) -> int:
        if fd not in (1, 2):
            return os.write(fd, data)
        return (process.streams.stdout if fd == 1 else process.streams.stderr).buffer.write(data)

    def get_terminal_size(fd: int = 1, /) -> Any:
        return os.terminal_size(process.streams.stdin.terminal_size())

    def isatty(fd: int, /) -> bool:
        if fd not in (0, 1, 2):
            return os.isatty(fd)
        return bool(process.streams.stdin.isatty() if fd == 0 else process.streams.stdout.isatty())

    return {'read': read, 'write': write, 'get_terminal_size': get_terminal_size, 'isatty': isatty}


def _commands(process: Process) -> dict[str, Any]:
    """Return functions that run shell lines with the process's view of `subprocess`."""

    def run(command: str, **options: Any) -> Any:
        subprocess: Any = process.loader.import_module('subprocess')
        return subprocess.run(command, shell=True, **options)

    def status(code: int) -> int:
        return code << 8 if code >= 0 else -code

    def popen(cmd: str, mode: str = 'r', buffering: int = -1) -> Reader:
        done = run(cmd, text=True, stdout=-1)
        return Reader(done.stdout, status(done.returncode))

    return {'system': lambda command: status(run(command).returncode), 'popen': popen}


def _exec(process: Process, name: str) -> Callable[..., None]:
    """Return a function such as `os.execv`: it ends the program, and another program receives its signals in its place."""

    def call(file: Any, *arguments: Any) -> None:
        *words, env = arguments if name.endswith('e') else (*arguments, None)
        subprocess: Any = process.loader.import_module('subprocess')
        child = subprocess.Popen([file, *(words[0] if name[4] == 'v' else words)[1:]], env=env)
        process.leave_graph()
        process.signals.handlers.update(dict.fromkeys(Signals, child.send_signal))
        process.lifecycle.exit_now(child.wait())

    return call


def _kill(process: Process, pid: int, signum: int) -> None:
    if pid == process.pid:
        process.send_signal(signum)
        return
    for other in process.host.processes:
        if other.pid == pid:
            other.send_signal(signum)
            return
    raise ProcessLookupError(3, 'No such process')


def _kill_group(process: Process, group: int, signum: int) -> None:
    """Send a signal to the program with the process ID `group` and to all programs that it started, itself the last."""
    members = [other for other in process.host.processes if _is_in(other, group)]
    if not members:
        raise ProcessLookupError(3, 'No such process')
    for member in sorted(members, key=lambda member: member is process):
        member.send_signal(signum)


def _is_in(process: Process | None, group: int) -> bool:
    return process is not None and (process.pid == group or _is_in(process.parent, group))


class SysView(ModuleType):
    """A view of `sys`. Each access to a name that does not belong to the program reads the real `sys`."""

    def __new__(cls, process: Process | str, *arguments: Any) -> ModuleType:  # type: ignore[misc]
        """Return a new view, or an ordinary module for a program that calls `type(sys)('name')`."""
        return ModuleType(process, *arguments) if isinstance(process, str) else super().__new__(cls)

    def __init__(self, process: Process) -> None:
        super().__init__('sys')
        self.__edulaunch_view__ = True
        self.argv = process.argv
        self.stdin = self.__stdin__ = process.streams.stdin
        self.stdout = self.__stdout__ = process.streams.stdout
        self.stderr = self.__stderr__ = process.streams.stderr
        self._shared_path = list(sys.path)
        self.path = [*process.loader.roots, *self._shared_path]
        self.modules = ChainMap(process.loader.modules, sys.modules)

    def __getattr__(self, name: str) -> Any:
        return getattr(sys, name)

    def private_path(self) -> tuple[list[str], list[str]]:
        """Return the folders that this program added to its path, as two lists.

        The first list contains the folders before all shared folders, and the second list the folders after the first shared
        folder.
        """
        first = next((place for place, folder in enumerate(self.path) if folder in self._shared_path), len(self.path))
        return self.path[:first], [folder for folder in self.path[first:] if folder not in self._shared_path]

    @staticmethod
    def exit(status: object = None) -> None:
        """Raise SystemExit, which ends this program only."""
        raise SystemExit(status)


def make_sys(view: ModuleType, process: Process) -> ModuleType:
    """Return a :class:`SysView` of the module."""
    return SysView(process)


Function = TypeVar('Function', bound=Callable[..., object])


def make_atexit(view: ModuleType, process: Process) -> ModuleType:
    """Make an `atexit` whose functions belong to this process."""
    calls = process.lifecycle.exit_calls

    def register(function: Function, /, *arguments: Any, **options: Any) -> Function:
        calls.append((function, arguments, options))
        return function

    def unregister(function: Callable[..., object], /) -> None:
        calls[:] = [call for call in calls if call[0] != function]

    view.__dict__.update(
        register=register,
        unregister=unregister,
        _clear=calls.clear,
        _ncallbacks=lambda: len(calls),
        _run_exitfuncs=process.lifecycle.run_exit_calls,
    )
    return view
