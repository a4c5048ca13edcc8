"""Prints, some time after Ctrl-C, which line of a program prevents the end of a run."""

from __future__ import annotations

import os
import signal
import sys
from types import FrameType, TracebackType
from typing import Any

from edulaunch.engine.processes.frame_owner import student_line

PATIENCE_S = 0.7
"""Real seconds between the press and the message."""


class StillBusy:
    """A context in which :meth:`press` starts the timer, and the end of the run stops it.

    The signal also arrives inside a call of C code that checks signals, such as a slow regular expression, where no thread runs.
    On systems without such a signal, nothing happens. The message goes to the error stream that existed when the context began.
    """

    def __init__(self) -> None:
        self._stream = sys.stderr
        self._before: Any = None
        self._is_armed = False

    def __enter__(self) -> StillBusy:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.stop()

    def stop(self) -> None:
        """Stop the timer, because the run has noticed Ctrl-C."""
        if self._is_armed:
            self._is_armed = False
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, self._before)

    def press(self) -> None:
        """Record that Ctrl-C was pressed, and start the timer. Call this method in the main thread."""
        if hasattr(signal, 'setitimer') and not self._is_armed:
            self._is_armed = True
            self._before = signal.signal(signal.SIGALRM, self._say)
            signal.setitimer(signal.ITIMER_REAL, PATIENCE_S)

    def _say(self, signum: int, frame: FrameType | None) -> None:
        line = student_line(frame)
        where = f'in {os.path.basename(line["file"])}:{line["line"]}' if line else 'busy'
        self._stream.write(f'\nnote: still {where}; press Ctrl-C or the interrupt button again to stop\n')
        self._stream.flush()
