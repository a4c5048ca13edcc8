"""A process that ends when the launch that it belongs to ends in whatever way, be it by SIGKILL."""

from __future__ import annotations

import ctypes
import fcntl
import os
import signal
import sys
import threading

_PR_SET_PDEATHSIG = 1
"""Of Linux's prctl(2)."""


def end_with(parent: int | str) -> None:
    """Let this process be killed when another one ends.

    :param parent: the number of the process that has started this one; 0: none. Or, for one that others started, a file that is
        locked as long as the other lives.
    """
    if isinstance(parent, str):
        threading.Thread(target=_wait_for, args=(parent,), daemon=True).start()
        return
    if not parent:
        return
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:  # it has ended before
        sys.exit(1)


def _wait_for(path: str) -> None:
    try:
        with open(path) as file:
            fcntl.flock(file, fcntl.LOCK_SH)
    except FileNotFoundError:
        pass  # it has ended, and cleaned up
    os.kill(os.getpid(), signal.SIGKILL)
