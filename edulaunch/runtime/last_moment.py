"""Saves the recording of a run that crashes in C code, or that is killed because a call of C code never returns.

Python runs its signal handlers only between two steps of its interpreter. A handler that ctypes creates runs immediately, in
the middle of other code, whose data may be inconsistent. So only a process that is about to end has such a handler.
"""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

FATAL = ('SIGABRT', 'SIGSEGV', 'SIGBUS', 'SIGILL', 'SIGFPE')
"""Signals that end a program after an error in C code, such as an invalid address or a failed check."""
KILLED = 'SIGUSR2'
"""The signal by which a watcher ends a run whose recording should be saved."""
LONGEST_S = 10
"""Real seconds that saving may take."""


@contextmanager
def last_moment(save: Callable[[], object]) -> Iterator[None]:
    """Call a function when a signal of `FATAL` or `KILLED` ends this process inside the block.

    :param save: the function, which writes the recording. The process ends after it, or after `LONGEST_S` seconds at the latest.
    """
    if sys.platform in ('win32', 'emscripten'):
        yield
        return
    import ctypes

    install = ctypes.CDLL(None).signal
    install.restype, install.argtypes = ctypes.c_void_p, (ctypes.c_int, ctypes.c_void_p)

    def end(signum: int) -> None:
        install(signal.SIGALRM, None)
        signal.alarm(LONGEST_S)
        install(signum, None)
        try:
            save()
        except BaseException as error:
            print(f'error: the recording is lost ({type(error).__name__}: {error})', file=sys.__stderr__, flush=True)
        if signum == getattr(signal, KILLED):
            signal.raise_signal(signal.SIGKILL)

    called = ctypes.CFUNCTYPE(None, ctypes.c_int)(end)
    numbers = [getattr(signal, name) for name in (*FATAL, KILLED)]
    before = [install(number, ctypes.cast(called, ctypes.c_void_p)) for number in numbers]
    try:
        yield
    finally:
        for number, handler in zip(numbers, before, strict=True):
            install(number, handler)
