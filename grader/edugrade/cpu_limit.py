"""Ends what takes too long in the grader's own process, such as drawing a recording that was made to be large."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class TooLong(Exception):
    """The processor time allowed for a piece of work is over."""


@contextmanager
def cpu_limit(seconds: float) -> Iterator[None]:
    """Raise TooLong inside when more than this processor time is used. A busy machine makes no difference.

    Only the main thread of a POSIX system can be limited; elsewhere nothing is.
    """
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, 'setitimer'):
        yield
        return

    def on_alarm(signum: int, frame: FrameType | None) -> None:
        raise TooLong(f'it took longer than {seconds:g} s of processor time')

    before = signal.signal(signal.SIGPROF, on_alarm)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
