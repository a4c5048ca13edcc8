"""Ctrl-C while C code waits for a function of ours has to wait: C code knows no exceptions, and would go on with nothing."""

from __future__ import annotations

import os
import signal
import threading
from _thread import interrupt_main
from types import FrameType

SOON_S = 0.001
_FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), '')


def defer() -> None:
    """Let KeyboardInterrupt come only outside of type support."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _interrupt)


def _interrupt(signum: int, frame: FrameType | None) -> None:
    at = frame
    while at is not None:
        if at.f_code.co_filename.startswith(_FOLDER):
            threading.Timer(SOON_S, interrupt_main).start()
            return
        at = at.f_back
    signal.default_int_handler(signum, frame)
