"""Delay Ctrl-C while C code waits for a function of edulaunch. C code cannot handle exceptions, and would use an invalid
result.
"""

from __future__ import annotations

import os
import signal
import threading
from _thread import interrupt_main
from types import FrameType

SOON_S = 0.0002
MOST_TRIES = 50
"""How often Ctrl-C is delayed if rclpy may be about to call C code. rclpy may be waiting for a service instead."""
_tries = 0
_FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), '')


def defer() -> None:
    """Install a handler that raises KeyboardInterrupt only outside type support."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _interrupt)


def _interrupt(signum: int, frame: FrameType | None) -> None:
    global _tries
    if _tries < MOST_TRIES and frame is not None and _calls_c(frame):
        _tries += 1
        _again()
        return
    _tries = 0
    at = frame
    while at is not None:
        if at.f_code.co_filename.startswith(_FOLDER):
            _again()
            return
        at = at.f_back
    signal.default_int_handler(signum, frame)


def _again() -> None:
    timer = threading.Timer(SOON_S, interrupt_main)
    timer.daemon = True  # so that an ending program does not wait for it
    timer.start()


def _calls_c(frame: FrameType) -> bool:
    """Return whether a frame is a function of rclpy that passes messages to C code. The executor calls such functions to take
    messages.
    """
    folder, file = os.path.split(frame.f_code.co_filename)
    return f'{folder}{os.sep}'.find(f'{os.sep}rclpy{os.sep}') >= 0 and (
        file != 'executors.py' or frame.f_code.co_name.startswith('_take')
    )
