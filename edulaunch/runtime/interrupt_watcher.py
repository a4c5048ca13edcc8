"""A process that runs next to `edulaunch launch` and reacts to Ctrl-C while Python itself cannot.

A call of C code such as `sum(range(10**12))` blocks Python's interpreter, so no signal handler and no other thread runs. The
kernel still writes the number of each signal into a pipe (`signal.set_wakeup_fd`), and this process reads the pipe. If Python
does not confirm a signal, the process names the line that is running, and at the third Ctrl-C it ends the run.

The second part of this file is a separate program, `python -I -S interrupt_watcher.py PID SIGNAL FOLDER...`. It uses only the
standard library, and starts within about 10 ms on another core.
"""

from __future__ import annotations

import os
import re
import select
import signal
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

HEARD = b'\0'
"""The byte by which Python confirms a signal: no signal has the number 0."""
PATIENCE_S = 1.0
"""Real seconds that Python has to confirm a signal."""
TERM_S = 3.0
"""Real seconds to confirm a signal that asks a run to end, such as SIGTERM. After them, the watcher ends the run."""
SAVE_S = 15.0
"""Real seconds to confirm such a signal for a run that saves its recording at its end."""
MOST_BYTES = 1 << 16
PLACE = re.compile(r'File "([^"]*)", line (\d+) in (\S+)')
_ENDING = ('SIGTERM', 'SIGHUP', 'SIGQUIT')


def innermost_own(traceback: str, libraries: Sequence[str]) -> str:
    """Return the innermost place of a student's code in a traceback of `faulthandler`, as `file:line (function)`.

    :param libraries: the beginnings of paths that do not belong to a student: the paths of Python, its packages, and
        edulaunch.
    :returns: an empty string when the traceback contains no such place.
    """
    own = [place for place in PLACE.findall(traceback) if not place[0].startswith(('<', *libraries))]
    if not own:
        return ''
    file, line, function = own[0]
    return f'{file}:{line}' + ('' if function == '<module>' else f' ({function})')


class WatchedSignals:
    """The pipe through which Python confirms that it has received a signal.

    :param pipe: the writing end; None when no watcher is running.
    """

    def __init__(self, pipe: int | None = None) -> None:
        self._pipe = pipe

    def forget(self) -> None:
        """Stop confirming signals, because another file may soon have the descriptor of the pipe."""
        self._pipe = None

    def confirm(self) -> None:
        """Inform the watcher that a signal handler in Python is running."""
        if self._pipe is not None:
            try:
                os.write(self._pipe, HEARD)
            except OSError:  # the watcher has ended, or the pipe is full of signals
                return


@contextmanager
def watched_signals(libraries: Sequence[str], is_watched: bool = True, end_by: str = 'SIGKILL') -> Iterator[WatchedSignals]:
    """Start a watcher for a block of code in the main thread. Signal handlers in the block must call `confirm`.

    On systems without such signals (Windows, a browser), or when no process can be started, the block runs without a watcher.

    :param libraries: the beginnings of paths that do not belong to a student; see :func:`innermost_own`.
    :param is_watched: whether to start a watcher at all.
    :param end_by: the signal that ends this process; see `last_moment.py`.
    """
    if not is_watched or not hasattr(signal, 'SIGUSR1') or sys.platform == 'emscripten':
        yield WatchedSignals()
        return
    import faulthandler
    import subprocess  # imported here: only a terminal needs it, and it takes as long to load as the rest of this module

    reading, writing = os.pipe()
    os.set_blocking(writing, False)
    command = [sys.executable, '-I', '-S', os.path.abspath(__file__), str(os.getpid()), end_by, *libraries]
    try:
        watcher = subprocess.Popen(command, stdin=reading, stdout=subprocess.DEVNULL, start_new_session=True)
    except OSError:
        os.close(reading)
        os.close(writing)
        yield WatchedSignals()
        return
    os.close(reading)
    before = signal.set_wakeup_fd(writing, warn_on_full_buffer=False)
    faulthandler.register(signal.SIGUSR1, writing, all_threads=False)
    watched = WatchedSignals(writing)
    try:
        yield watched
    finally:
        watched.forget()
        signal.set_wakeup_fd(before)
        faulthandler.unregister(signal.SIGUSR1)
        os.close(writing)
        watcher.wait()


class Watcher:
    """Reads the pipe of one run, prints notes, and ends the run if Python does not react.

    :param pid: the process ID of the run.
    :param pipe: the reading end of the pipe.
    :param end_by: the signal that ends the run.
    :param libraries: the beginnings of paths that do not belong to a student; see :func:`innermost_own`.
    """

    def __init__(self, pid: int, pipe: int, end_by: int, libraries: Sequence[str]) -> None:
        self._pid, self._pipe, self._end_by, self._libraries = pid, pipe, end_by, libraries
        self._presses = 0
        self._judge_at_s: float | None = None
        self._end_at_s: float | None = None
        self._ending = {int(getattr(signal, name)) for name in _ENDING}

    def run(self) -> None:
        """Watch until the run closes its end of the pipe."""
        while True:
            waits = [at for at in (self._judge_at_s, self._end_at_s) if at is not None]
            left_s = max(0.0, min(waits) - time.monotonic()) if waits else None
            if not select.select([self._pipe], [], [], left_s)[0]:
                self._judge()
                continue
            data = os.read(self._pipe, MOST_BYTES)
            if not data:
                return
            self._hear(data)

    def _hear(self, data: bytes) -> None:
        now_s = time.monotonic()
        for byte in data:
            if byte == HEARD[0]:
                self._presses, self._judge_at_s, self._end_at_s = 0, None, None
            elif byte == signal.SIGINT:
                self._presses += 1
                self._judge_at_s = now_s + PATIENCE_S
            elif byte in self._ending and self._end_at_s is None:
                self._end_at_s = now_s + TERM_S

    def _judge(self) -> None:
        """React to a signal that Python has not confirmed in time."""
        now_s = time.monotonic()
        if self._end_at_s is not None and now_s >= self._end_at_s:
            self._end(f'{self._where()} prevents the end of the run')
        elif self._judge_at_s is not None and now_s >= self._judge_at_s:
            self._judge_at_s = None
            if self._presses >= 3:
                self._end(f'{self._where()} cannot be interrupted')
            elif self._presses:
                again = 'once more' if self._presses == 2 else 'twice more'
                _print(f'note: {self._where()} is in a call that Python cannot interrupt; press Ctrl-C {again} to kill the run')

    def _where(self) -> str:
        """Request the current line of the run. faulthandler prints it even while C code runs."""
        os.kill(self._pid, signal.SIGUSR1)
        text, end_s = '', time.monotonic() + PATIENCE_S
        while not innermost_own(text, self._libraries) and (left_s := end_s - time.monotonic()) > 0:
            if not select.select([self._pipe], [], [], left_s)[0]:
                break
            data = os.read(self._pipe, MOST_BYTES)
            if not data:
                break
            self._hear(data)
            text += data.decode('utf-8', 'replace')
        place = innermost_own(text, self._libraries)
        return f'a program at {place}' if place else 'a program'

    def _end(self, why: str) -> None:
        _print(f'error: {why}: the run was killed')
        os.kill(self._pid, self._end_by)
        self._end_by, self._end_at_s = signal.SIGKILL, time.monotonic() + SAVE_S


def _print(line: str) -> None:
    sys.stderr.write(f'\n{line}\n')
    sys.stderr.flush()


def main() -> None:
    """Run the watcher as a program."""
    try:
        Watcher(int(sys.argv[1]), sys.stdin.fileno(), getattr(signal, sys.argv[2]), sys.argv[3:]).run()
    except ProcessLookupError:  # the run has ended meanwhile
        return


if __name__ == '__main__':
    main()
