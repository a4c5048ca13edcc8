"""The starter of runs, on a computer on which one call fails, in whichever process that is.

The file that the test names has three numbers: how many calls from now the fault comes (0: never), its number, and how many calls
there were. It is shared with everything that the starter forks. The number `LOADING` makes the loading of an extension module fail,
as it does when memory cannot be mapped; all other numbers make a function of `os`, `socket` or `open` fail. `FIRST_OF_EACH` makes the
first fork and the first thread of every process fail, and `NO_PROCESSES` every fork.
"""

from __future__ import annotations

import _imp
import builtins
import errno
import io
import mmap
import os
import runpy
import socket
import struct
import sys
import threading
from collections.abc import Callable
from typing import Any

FORM = '=qqq'
LOADING, FIRST_OF_EACH, NO_PROCESSES = -1, -2, -3
CALLS: dict[Any, tuple[str, ...]] = {
    os: (
        *('open', 'write', 'read', 'fork', 'fsync', 'mkdir', 'pipe', 'dup', 'dup2', 'chdir'),
        *('chmod', 'listdir', 'rename', 'replace', 'rmdir', 'scandir', 'symlink', 'unlink'),
    ),
    socket: ('socketpair', 'send_fds', 'recv_fds'),
    socket.socket: ('sendmsg', 'recvmsg', 'sendall', 'recv'),
    mmap: ('mmap',),
}

_create_dynamic: Callable[..., Any] = _imp.create_dynamic
_start_thread: Callable[..., Any] = threading.Thread.start


def failing(function: Callable[..., Any], memory: mmap.mmap) -> Callable[..., Any]:
    """The same function, counted, which fails when its turn has come."""

    def call(*arguments: Any, **options: Any) -> Any:
        left, number, count = struct.unpack(FORM, memory[:24])
        if (number == LOADING) != (function is _create_dynamic):
            return function(*arguments, **options)
        memory[:24] = struct.pack(FORM, max(0, left - 1), number, count + 1)
        if left == 1:
            if number == LOADING:
                raise ImportError('a.so: failed to map segment from shared object')
            if function is _start_thread:
                raise RuntimeError("can't start new thread")
            raise OSError(number, os.strerror(number))
        return function(*arguments, **options)

    return call


def short_of_processes(memory: mmap.mmap) -> None:
    """Let the computer have no process and no thread for a moment, or for ever, as the file says."""
    fork, start = os.fork, threading.Thread.start
    done: set[tuple[int, str]] = set()

    def lacks(what: str) -> bool:
        key = (os.getpid(), what)
        number = struct.unpack(FORM, memory[:24])[1]
        is_first, _ = key not in done, done.add(key)
        return (number == FIRST_OF_EACH and is_first) or (number == NO_PROCESSES and what == 'fork')

    def forks() -> int:
        if lacks('fork'):
            raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        return fork()

    def starts(thread: threading.Thread) -> None:
        if lacks('thread'):
            raise RuntimeError("can't start new thread")
        start(thread)

    os.fork, threading.Thread.start = forks, starts  # type: ignore[method-assign]


def main(starter: str, shared: str) -> None:
    """Be the starter, with faults."""
    with open(shared, 'r+b') as file:
        memory = mmap.mmap(file.fileno(), 24)
    for module, names in CALLS.items():
        for name in names:
            setattr(module, name, failing(getattr(module, name), memory))
    threading.Thread.start = failing(_start_thread, memory)  # type: ignore[method-assign]
    short_of_processes(memory)
    _imp.create_dynamic = failing(_create_dynamic, memory)
    builtins.open = io.open = failing(io.open, memory)
    runpy.run_path(starter, run_name='__main__')


if __name__ == '__main__':
    starter, shared = sys.argv[2:]
    del sys.argv[2:]
    main(starter, shared)
