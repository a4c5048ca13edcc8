"""Loads the module of a command and runs it. During this time, Ctrl-C and a lack of memory cause no traceback."""

from __future__ import annotations

import gc
import signal
import sys
from collections.abc import Callable
from importlib import import_module

INTERRUPTED = 130
UNUSABLE = 2
LOADING_FAULTS = ('failed to map segment', 'Cannot allocate memory', 'Too many open files', "can't start new thread")
"""Parts of the error messages that appear while a module loads and the computer has run out of a resource."""


def run_quietly(module: str, name: str, broken: int = UNUSABLE) -> int:
    """Load a command and run it. While it loads, Ctrl-C ends the process immediately and without a traceback.

    :param broken: the exit code when the command cannot be loaded, because this computer has no memory or file descriptors left.
    """
    try:
        try:
            command = _loaded(module, name)
        except (ImportError, MemoryError, OSError) as error:
            if not isinstance(error, MemoryError) and not any(text in str(error) for text in LOADING_FAULTS):
                raise
            print(f'error: this computer has no memory or descriptors left: {error}', file=sys.stderr)
            return broken
        return command()
    except KeyboardInterrupt:
        return INTERRUPTED


def _loaded(module: str, name: str) -> Callable[[], int]:
    """Return a command. Afterwards, Python's handler of Ctrl-C is set again, even if the module could not be loaded."""
    before = signal.getsignal(signal.SIGINT)
    if before is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    gc.disable()  # without garbage collection, this takes a tenth less time
    try:
        command: Callable[[], int] = getattr(import_module(module), name)
        return command
    finally:
        gc.enable()
        if before is signal.default_int_handler:
            signal.signal(signal.SIGINT, before)
