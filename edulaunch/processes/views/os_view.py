"""`os` of a simulated program: its own environment, pid and end."""
from __future__ import annotations

import os as real
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def make(view: ModuleType, process: Process) -> ModuleType:
    """`environ` is the process's own dict; `kill` reaches simulated processes by their simulated pid and nothing else."""

    def kill(pid: int, signum: int) -> None:
        if pid == process.pid:
            process.send_signal(signum)
            return
        for other in process.host.processes:
            if other.pid == pid:
                other.send_signal(signum)
                return
        raise ProcessLookupError(3, 'No such process')

    def putenv(name: str, value: str) -> None:
        process.env[name] = value

    def getenv(name: str, default: Any = None) -> Any:
        return process.env.get(name, default)

    view.__dict__.update(
        environ=process.env, getenv=getenv, putenv=putenv, unsetenv=lambda name: process.env.pop(name, None),
        getpid=lambda: process.pid, getppid=lambda: 1000, kill=kill, _exit=process.exit_now,
        getcwd=lambda: process.spec.cwd or real.getcwd())
    copy_names(view, real)
    return view
