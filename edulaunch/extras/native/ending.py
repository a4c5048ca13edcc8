"""Functions that end a process together with its launch, even if SIGKILL ends the launch."""

from __future__ import annotations

import ctypes
import fcntl
import os
import signal
import sys
import threading

_PR_SET_PDEATHSIG = 1
"""A constant of Linux's prctl(2)."""


def end_with(parent: int | str) -> None:
    """Kill this process when its parent ends.

    :param parent: the number of the process that has started this one, or 0 for no parent. A string is the path of a file
        that is locked while the parent runs.
    """
    if isinstance(parent, str):
        threading.Thread(target=_wait_for, args=(parent,), daemon=True).start()
        return
    if not parent:
        return
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:  # the parent has already ended
        sys.exit(1)


def _wait_for(path: str) -> None:
    try:
        with open(path) as file:
            fcntl.flock(file, fcntl.LOCK_SH)
    except FileNotFoundError:
        pass  # the parent has ended and cleaned up
    os.kill(os.getpid(), signal.SIGKILL)
