"""Keeps the recording of a run that ends early: because of a signal from outside, or for lack of memory or open files."""

from __future__ import annotations

import errno
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import FrameType, TracebackType
from typing import Any

from edulaunch.errors import EdulaunchError
from edulaunch.runtime.interrupt_watcher import WatchedSignals

ENDING = ('SIGTERM', 'SIGHUP', 'SIGQUIT')
"""Signals that end a program: `kill`, a closed terminal, Ctrl-backslash."""
SPENT = (errno.EMFILE, errno.ENFILE, errno.ENOMEM)
MEMORY_BYTES = 32 << 20
DESCRIPTORS = 8


class Ending:
    """Stops a run between two steps at the first signal of `ENDING`. A second signal raises KeyboardInterrupt.

    Without this context, Python would end immediately and lose the recording. Signals that are ignored (`nohup`) or have another
    handler do not change. Outside the main thread, no signal changes.

    :param stop: a function that is called at the first signal.
    :ivar came: the first signal that arrived, or None.
    :ivar watched: the pipe that confirms each signal that has arrived.
    :ivar is_saving: whether the run is over and its recording is being written. Further signals then have no effect.
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
        """Return a message that names the signal that ended the run, and the simulated time in seconds."""
        return f'{signal.Signals(self.came or 0).name} ended the run at {elapsed_s:.2f} s of simulated time'


@contextmanager
def first_interrupt_waits(text: str) -> Iterator[None]:
    """Make the first Ctrl-C during important work print only a note. The second Ctrl-C interrupts the work.

    :param text: the note, which names the work and what a second Ctrl-C loses.
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
    """Memory and file descriptors that are reserved for the end of a run, because a program may use up everything else."""

    def __init__(self) -> None:
        self._memory = bytes(MEMORY_BYTES)  # a bytearray would write to each page, which takes 20 ms and the memory itself
        self._files: list[int] = []
        with suppress(OSError):  # a computer without descriptors runs without a reserve
            self._files += (os.open(os.devnull, os.O_RDONLY) for _ in range(DESCRIPTORS))

    def release(self) -> None:
        """Release the reserve. Later calls have no effect."""
        self._memory = b''
        while self._files:
            os.close(self._files.pop())


def spent(error: BaseException | None) -> EdulaunchError | None:
    """Return the error to report if a program used all memory or all open files. Return None for any other error."""
    if isinstance(error, MemoryError):
        what, help = 'memory', 'look for a list or string in a program that grows without limit'
    elif isinstance(error, OSError) and error.errno in SPENT:
        what, help = f'resources ({error.strerror})', 'look for a program that opens files or sockets and never closes them'
    else:
        return None
    return EdulaunchError(f'the run ended early, because its programs used all {what} of this computer', help=help)


def run_kept(run: Callable[[], object], stop: Callable[[], object], note_end: Callable[[], object]) -> None:
    """Run a simulation. If a signal, or a lack of memory or open files, ends it early, keep its recording.

    :param stop: a function that makes the simulation stop between two steps.
    :param note_end: a function that records the early end.
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
    """Return the lines of advice from `look`. If that fails, return one warning, so that the recording is not lost."""
    try:
        return look()
    except Exception as error:
        return [f'warning: edulaunch could not check this run for mistakes ({type(error).__name__}: {error})']
