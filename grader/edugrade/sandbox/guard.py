"""Stands between the starter and one run: it begins the run, watches all that the run starts, and ends all of it.

It is no part of what is confined. Orphans of the run become its children (it is their subreaper), so that nothing gets away.
"""

from __future__ import annotations

import json
import os
import select
import signal
import socket
import time
from collections.abc import Callable
from contextlib import suppress
from typing import NoReturn

from .remove_tree import remove_tree
from .system import PR_SET_CHILD_SUBREAPER, PR_SET_PDEATHSIG, prctl

LOOK_S = 0.05
MOST_PROCESSES = 64
PAGE_BYTES = os.sysconf('SC_PAGE_SIZE')


def guard(link: socket.socket, home: str, memory_bytes: int, begin: Callable[[], NoReturn]) -> NoReturn:
    """Begin a run in a process of its own, tell its pid and how it ended; end all it started, then this process.

    :param link: to the runner. It gets lines of JSON: ``{"pid": 77, "guard": 76}``, then ``{"status": -9}``, or ``"cut"``:
        ``"processes"`` or ``"memory"`` for a run that used too much. When its other end is closed, the run is ended; when this
        end is, all is over.
    :param home: the run's private folder, which is removed afterwards, even when the grader was killed.
    :param memory_bytes: for all processes of the run together.
    :param begin: what the run does.
    """
    with suppress(OSError):
        prctl(PR_SET_CHILD_SUBREAPER, 1)
    pid = os.fork()
    if pid == 0:
        link.close()
        with suppress(OSError):
            prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        begin()
    told: dict[str, object] = {}
    try:
        link.sendall(json.dumps({'pid': pid, 'guard': os.getpid()}).encode() + b'\n')
        told = _watch(link, pid, memory_bytes)
    except OSError:  # the runner is gone
        pass
    finally:
        end_all(pid)
        remove_tree(home)
    with suppress(OSError):
        link.sendall(json.dumps(told).encode() + b'\n')
    os._exit(0)


def _watch(link: socket.socket, pid: int, memory_bytes: int) -> dict[str, object]:
    """Wait until the run ends, the runner lets go, or too much is used."""
    ends = select.poll()  # not `select`, which knows no numbers above 1023
    ends.register(link, select.POLLIN)
    with suppress(OSError, AttributeError):
        ends.register(os.pidfd_open(pid), select.POLLIN)
    while True:
        if any(end == link.fileno() for end, _ in ends.poll(LOOK_S * 1000)):
            return {}
        ended, status = os.waitpid(pid, os.WNOHANG)
        if ended:
            return {'status': os.waitstatus_to_exitcode(status)}
        started = descendants(os.getpid())
        if len(started) > MOST_PROCESSES:
            return {'cut': 'processes'}
        if len(started) > 1 and _memory(started, 'statm') > memory_bytes and _memory(started, 'smaps_rollup') > memory_bytes:
            return {'cut': 'memory'}


def end_all(pid: int) -> None:
    """Kill a process of ours, its group and every descendant of this process, until none is left."""
    while True:
        with suppress(OSError):
            os.killpg(pid, signal.SIGKILL)
        for each in [pid, *descendants(os.getpid())]:
            with suppress(OSError):
                os.kill(each, signal.SIGKILL)
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            return
        time.sleep(0.001)


def descendants(pid: int) -> list[int]:
    """All processes that a process started, and those that these started; [] where the system does not tell (it needs /proc)."""
    found: list[int] = []
    pending = [pid]
    while pending:
        number = pending.pop()
        with suppress(OSError):
            for task in os.listdir(f'/proc/{number}/task'):
                with suppress(OSError), open(f'/proc/{number}/task/{task}/children') as file:
                    children = [int(word) for word in file.read().split()]
                    found += children
                    pending += children
    return found


def _memory(pids: list[int], source: str) -> int:
    """Bytes that processes use: `statm` is quick and counts what they share for each, `smaps_rollup` does not."""
    total = 0
    for pid in pids:
        with suppress(OSError, ValueError, IndexError, StopIteration), open(f'/proc/{pid}/{source}') as file:
            if source == 'statm':
                total += int(file.read().split()[1]) * PAGE_BYTES
            else:
                total += next(int(line.split()[1]) for line in file if line.startswith('Pss:')) * 1024
    return total
