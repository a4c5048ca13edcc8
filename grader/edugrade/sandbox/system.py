"""System calls for which Python has no functions."""

from __future__ import annotations

import ctypes
import errno
import os
import signal
import sys
import time
from contextlib import suppress
from typing import Any

PR_SET_PDEATHSIG, PR_CAPBSET_DROP, PR_SET_NO_NEW_PRIVS, PR_SET_CHILD_SUBREAPER = 1, 24, 38, 36
IS_LINUX = sys.platform.startswith('linux')

FAULTS = frozenset({errno.EAGAIN, errno.ENOMEM, errno.EMFILE, errno.ENFILE, errno.EIO})
"""Errors of a computer that has too little of something now, or whose disk fails.

They do not mean that the system lacks a function.
"""
PAUSES_S = (0.01, 0.03, 0.1, 0.3)

libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long


def syscall(number: int, *arguments: Any) -> int:
    """Call the kernel by the number of a system call, and return the result.

    :raises OSError: with the error of the kernel.
    """
    wide = [ctypes.c_long(value) if isinstance(value, int) else value for value in arguments]
    return _checked(int(libc.syscall(ctypes.c_long(number), *wide)))


def prctl(option: int, value: int = 0, more: Any = 0) -> int:
    """Call prctl(2), and return the result.

    :raises OSError: with the error of the kernel.
    """
    if not IS_LINUX:
        raise OSError('only Linux has prctl')
    return _checked(
        int(libc.prctl(option, ctypes.c_ulong(value), more if not isinstance(more, int) else ctypes.c_ulong(more), 0, 0))
    )


def fork() -> int:
    """Fork like `os.fork`. If the computer has no processes left, retry for almost half a second.

    A Ctrl-C during the fork takes effect afterwards, because Python ignores exceptions in the functions that it calls after a
    fork.

    :raises OSError: if the fork still fails.
    """
    for pause in PAUSES_S:
        with suppress(OSError):
            return _fork()
        time.sleep(pause)
    return _fork()


def _fork() -> int:
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        return os.fork()
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def effective_capabilities() -> int:
    """Return the first 32 capabilities that this process has now, one bit for each."""
    header, sets = (ctypes.c_uint32 * 2)(0x20080522, 0), (ctypes.c_uint32 * 6)()
    _checked(int(libc.capget(header, sets)))
    return int(sets[0])


def _checked(result: int) -> int:
    if result < 0:
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))
    return result
