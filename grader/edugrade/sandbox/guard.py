"""The guard of one run: it starts the run, watches all its processes, and ends all of them.

The guard itself is not confined. Orphans of the run become its children (it is their subreaper), so that no process escapes.
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

from . import seccomp
from .allowance import MOST_BYTES, MOST_FILES, MOST_PROCESSES, MOST_THREADS
from .remove_tree import remove_tree
from .system import PR_SET_CHILD_SUBREAPER, PR_SET_PDEATHSIG, fork, prctl

LOOK_S = 0.1
GLANCE_S = 0.01  # a program can start thousands of threads between two measurements
PAGE_BYTES = os.sysconf('SC_PAGE_SIZE')
MANY_DESCRIPTORS = 64  # a process with fewer descriptors has little memory in buffers
SOCKET_BYTES = 212_992  # bytes in the buffer of one socket if the system does not report them; a run cannot enlarge it


def guard(link: socket.socket, home: str, memory_bytes: int, begin: Callable[[socket.socket], NoReturn]) -> NoReturn:
    """Start a run in its own process, and report its pid and its end. Then end all processes of the run, and this process.

    :param link: the socket to the runner, which receives lines of JSON. The first line is ``{"pid": 77, "guard": 76}``. The last
        line has ``"status": -9``, or ``"cut"`` with ``"processes"``, ``"memory"`` or ``"disk"`` for a run that used too much.
        If system calls were refused, it also has their names in ``"refused"``. When the runner closes its end, the guard ends the
        run. When the guard closes its end, all processes have ended.
    :param home: the run's private folder, which is removed afterwards, even if the grader was killed.
    :param memory_bytes: the limit for all processes of the run together.
    :param begin: a function that runs the scenario. Its argument is a socket for the descriptor that receives refused calls.
    :raises OSError: if the computer cannot start a process for the run.
    """
    with suppress(OSError):
        prctl(PR_SET_CHILD_SUBREAPER, 1)
    notes, end = socket.socketpair()
    pid = fork()
    if pid == 0:
        link.close()
        notes.close()
        with suppress(OSError):
            prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        begin(end)
    end.close()
    result: dict[str, object] = {}
    refused: dict[str, None] = {}
    try:
        link.sendall(json.dumps({'pid': pid, 'guard': os.getpid()}).encode() + b'\n')
        result = _Watch(link, notes, pid, home, memory_bytes, refused).until_it_ends()
    except OSError:  # the runner has ended
        pass
    finally:
        end_all(pid)
        remove_tree(home)
    if refused:
        result['refused'] = list(refused)
    with suppress(OSError):
        link.sendall(json.dumps(result).encode() + b'\n')
    os._exit(0)


class _Watch:
    """The observation of one run until it ends or exceeds a limit.

    :param notes: the socket on which the listener for refused calls arrives.
    :param refused: the dict to which the names of refused calls are added.
    """

    def __init__(
        self, link: socket.socket, notes: socket.socket, pid: int, home: str, memory_bytes: int, refused: dict[str, None]
    ) -> None:
        self._link = link
        self._notes = notes
        self._pid = pid
        self._home = home
        self._memory_bytes = memory_bytes
        self._refused = refused
        self._listener = -1
        self._started = [pid]
        self._ends = select.poll()  # not `select`, which does not support descriptors above 1023
        for end in (link, notes):
            self._ends.register(end, select.POLLIN)
        with suppress(OSError, AttributeError):
            self._ends.register(os.pidfd_open(pid), select.POLLIN)

    def until_it_ends(self) -> dict[str, object]:
        """Wait until the run has ended, the runner closes its end, or the run exceeds a limit. Return the result for the
        runner.
        """
        next_look = 0.0
        while True:
            for end, event in self._ends.poll(GLANCE_S * 1000):
                if end == self._link.fileno():
                    return {}
                self._hear(end, event)
            ended, status = os.waitpid(self._pid, os.WNOHANG)
            if ended:
                return {'status': os.waitstatus_to_exitcode(status)}
            if _threads(self._started) > MOST_THREADS:
                return {'cut': 'processes'}
            if time.monotonic() >= next_look:
                cut = self._too_much()
                if cut:
                    return {'cut': cut}
                next_look = time.monotonic() + LOOK_S

    def _hear(self, end: int, event: int) -> None:
        """Receive the listener, or refuse the call that waits for an answer."""
        if end == self._notes.fileno():
            self._ends.unregister(end)
            with suppress(OSError):
                _, descriptors, _, _ = socket.recv_fds(self._notes, 1, 1)
                for self._listener in descriptors:
                    self._ends.register(self._listener, select.POLLIN)
        elif end == self._listener:
            name = seccomp.refuse_next(end) if event & select.POLLIN else None
            if name is not None:
                self._refused.setdefault(name)
            elif event & select.POLLHUP:
                self._ends.unregister(end)

    def _too_much(self) -> str:
        """Return the name of the limit that the run exceeds, or ''."""
        self._started = started = descendants(os.getpid())
        if len(started) > MOST_PROCESSES:
            return 'processes'
        buffers = _buffers(started)
        limit = self._memory_bytes - buffers
        if (len(started) > 1 or buffers) and all(_memory(started, source) > limit for source in ('statm', 'smaps_rollup')):
            return 'memory'
        return '' if _fits(self._home) else 'disk'


def _fits(folder: str) -> bool:
    """Return whether the content of a directory is within the limits. (For a run with its own view, the system enforces the
    limits.)
    """
    count, size = 0, 0
    pending = [folder]
    while pending:
        with suppress(OSError), os.scandir(pending.pop()) as entries:
            for entry in entries:
                count += 1
                with suppress(OSError):
                    size += entry.stat(follow_symlinks=False).st_blocks * 512
                    if entry.is_dir(follow_symlinks=False):
                        pending.append(entry.path)
                if count > MOST_FILES or size > MOST_BYTES:
                    return False
    return True


def end_all(pid: int) -> None:
    """Kill a child process, its group and every descendant of this process, until no descendant exists."""
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
    """Return all descendants of a process, or [] on a system without /proc."""
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


def _threads(pids: list[int]) -> int:
    """Return the total number of threads of some processes."""
    count = 0
    for pid in pids:
        with suppress(OSError):
            count += os.stat(f'/proc/{pid}/task').st_nlink - 2
    return count


def _buffers(pids: list[int]) -> int:
    """Return the bytes that the sockets of processes can buffer. The memory of a process does not include them."""
    sockets: set[str] = set()
    for pid in pids:
        with suppress(OSError):
            names = os.listdir(f'/proc/{pid}/fd')
            for name in names if len(names) > MANY_DESCRIPTORS else ():
                with suppress(OSError):
                    place = os.readlink(f'/proc/{pid}/fd/{name}')
                    if place.startswith('socket:'):
                        sockets.add(place)
    return len(sockets) * _socket_bytes() if sockets else 0


def _socket_bytes() -> int:
    with suppress(OSError, ValueError), open('/proc/sys/net/core/wmem_default') as file:
        return int(file.read())
    return SOCKET_BYTES


def _memory(pids: list[int], source: str) -> int:
    """Return the bytes that processes use.

    :param pids: the processes.
    :param source: 'statm' or 'smaps_rollup'. 'statm' is quick, but counts shared memory for each process.
    """
    total = 0
    for pid in pids:
        with suppress(OSError, ValueError, IndexError, StopIteration), open(f'/proc/{pid}/{source}') as file:
            if source == 'statm':
                total += int(file.read().split()[1]) * PAGE_BYTES
            else:
                total += next(int(line.split()[1]) for line in file if line.startswith('Pss:')) * 1024
    return total
