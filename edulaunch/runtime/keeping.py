"""What lets the recording of a run be kept whatever ends it: signals from outside, no memory left, no open file left."""

from __future__ import annotations

import errno
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType, TracebackType
from typing import Any

from edulaunch.errors import EdulaunchError
from edulaunch.runtime.interrupt_watcher import WatchedSignals

ENDING = ('SIGTERM', 'SIGHUP', 'SIGQUIT')
"""Signals that end a program: `kill`, a terminal that closes, Ctrl-backslash."""
SPENT = (errno.EMFILE, errno.ENFILE, errno.ENOMEM)
MEMORY_BYTES = 32 << 20
DESCRIPTORS = 8


class Ending:
    """In force, the first signal of `ENDING` lets a run stop between two steps; a second one raises KeyboardInterrupt.

    Python would end at once, and the recording with it. A signal that somebody else handles or ignores (`nohup`) stays as it is,
    and so do all of them outside the main thread.

    :param stop: called at the first signal.
    :ivar came: the first signal that came; None before.
    :ivar watched: where a signal that was heard is confirmed.
    :ivar is_saving: the run is over and its recording is written: further signals wait until that is done.
    """

    def __init__(self, stop: Callable[[], object] = lambda: None) -> None:
        self.came: int | None = None
        self.is_saving = False
        self.watched = WatchedSignals()
        self._stop = stop
        self._before: dict[int, Any] = {}

    def __enter__(self) -> Ending:
        if threading.current_thread() is threading.main_thread():
            for number in (getattr(signal, name) for name in ENDING if hasattr(signal, name)):
                if signal.getsignal(number) is signal.SIG_DFL:
                    self._before[number] = signal.signal(number, self._hear)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _hear(self, signum: int, frame: FrameType | None) -> None:
        self.watched.confirm()
        is_first, self.came = self.came is None, self.came or signum
        if is_first:
            self._stop()
        elif not self.is_saving:
            raise KeyboardInterrupt

    def text(self, elapsed_s: float) -> str:
        """What ended the run, and when in simulated seconds."""
        return f'{signal.Signals(self.came or 0).name} ended the run at {elapsed_s:.2f} s of simulated time'


@contextmanager
def first_interrupt_waits(text: str) -> Iterator[None]:
    """Let the first Ctrl-C print a note only, while something is done that should be finished. The second one interrupts.

    :param text: the note: what is done, and what a second Ctrl-C gives up.
    """
    before = signal.getsignal(signal.SIGINT)
    if before is not signal.default_int_handler or threading.current_thread() is not threading.main_thread():
        yield
        return

    def wait(signum: int, frame: FrameType | None) -> None:
        signal.signal(signal.SIGINT, before)
        print(f'note: {text}', file=sys.stderr)

    signal.signal(signal.SIGINT, wait)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


class Reserve:
    """Some memory and open files that are put aside for the end of a run, when a program may have taken all others."""

    def __init__(self) -> None:
        self._memory = bytearray(MEMORY_BYTES)
        self._files = [os.open(os.devnull, os.O_RDONLY) for _ in range(DESCRIPTORS)]

    def release(self) -> None:
        """Give them back; doing it twice is doing it once."""
        self._memory = bytearray()
        while self._files:
            os.close(self._files.pop())


def spent(error: BaseException | None) -> EdulaunchError | None:
    """The sentence for an error that says that a program took all memory or all open files; None for any other error."""
    if isinstance(error, MemoryError):
        what, help = 'memory', 'look for a list or a text in a program that grows without end'
    elif isinstance(error, OSError) and error.errno in SPENT:
        what, help = f'resources ({error.strerror})', 'look for a program that opens files or sockets and never closes them'
    else:
        return None
    return EdulaunchError(f'the programs of the run took all {what} that this computer gives; the run ended there', help=help)


def run_kept(run: Callable[[], object], stop: Callable[[], object], note_end: Callable[[], object]) -> None:
    """Run a simulation so that a signal, or a program that takes everything, ends it and leaves its recording.

    :param stop: lets it stop between two steps.
    :param note_end: records that it ended before its time.
    """
    reserve = Reserve()
    try:
        with Ending(stop) as ending:
            run()
        if ending.came is not None:
            note_end()
    except (MemoryError, OSError) as error:
        if (known := spent(error)) is None:
            raise
        reserve.release()
        note_end()
        print(f'error: {known}', file=sys.stderr)
    finally:
        reserve.release()


def advice_or_why_not(look: Callable[[], list[str]]) -> list[str]:
    """The lines of advice that `look` makes; one line that says so when it fails: advice costs no recording."""
    try:
        return look()
    except Exception as error:
        return [f'warning: edulaunch could not look for advice on this run ({type(error).__name__}: {error})']
