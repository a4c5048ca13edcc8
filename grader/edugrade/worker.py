"""Does work within limits, in a separate process or with a limit on processor time.

A worker is a fork of the grader. It needs no input, and answers with JSON. If it fails, only one submission is affected.
Other runs continue while it works.
"""

from __future__ import annotations

import gc
import json
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from time import monotonic
from types import FrameType
from typing import Any, NoReturn

from .job import CAN_FORK, MEBI
from .readiness import is_readable

LONGEST_CPU_S = 12  # processor time in seconds; a grading usually takes a tenth of a second
LONGEST_S = 300.0  # seconds of real time; other programs may keep the computer busy, so reaching it is not a verdict
MOST_MEMORY_MIB = 1024  # limit in addition to the memory of the grader
TRIES = 3
LOOK_S = 0.05
REMIND_S = 0.05  # processor time after which TooLong is raised again
CHUNK_BYTES = 1 << 18
MOST_DESCRIPTORS = 4096
REGISTRY = 'edulaunch.engine.interfaces.registry'
SHORT_OF_MEMORY, BROKE, UNHEARD = 3, 4, 5  # exit codes; the last one means that there was no reply

Attend = Callable[[int, float], bool]

_attending: list[Attend] = []
_to_load: list[str] = []
"""The modules that the last workers had to load, for the next worker."""


class Exceeded(Exception):
    """A piece of work has exceeded its limits."""


class Lost(Exception):
    """Another process killed the worker in every attempt, or the worker took too long. (Limits end a worker in other ways.)"""


@contextmanager
def attended(attend: Attend) -> Iterator[None]:
    """Use a function for waiting for workers, while this context manager is active.

    :param attend: a function that gets a descriptor and a number of seconds. It returns whether the descriptor is readable.
    """
    _attending.append(attend)
    try:
        yield
    finally:
        _attending.remove(attend)


def in_worker(work: Callable[[], Any]) -> Any:
    """Call `work` in a worker, and return the result after a conversion to JSON and back.

    A process with threads (such as a notebook's) cannot fork safely, so it does the work itself, without these limits.

    :raises Exceeded: if the work used too much processor time or memory.
    :raises Lost: if the worker was killed, or has not finished after LONGEST_S.
    :raises RuntimeError: with the name and message of an exception that `work` raised.
    """
    if not CAN_FORK or threading.active_count() > 1:
        return json.loads(_text(work))
    for _ in range(TRIES):
        code, answer = _once(work)
        if code == 0:
            return json.loads(answer)
        if code == -signal.SIGXCPU:
            raise Exceeded(f'it took longer than {LONGEST_CPU_S} s of processor time')
        if code == SHORT_OF_MEMORY:
            raise Exceeded(f'it needed more than {MOST_MEMORY_MIB} MiB of memory')
        if code == BROKE:
            raise RuntimeError(answer.decode('utf-8', 'replace'))
    raise Lost('another program killed the process that judges')


def _once(work: Callable[[], Any]) -> tuple[int, bytes]:
    """Return the exit code of a worker (negative if a signal ended it), and its answer."""
    from .sandbox.system import fork

    _load()
    for stream in (sys.stdout, sys.stderr):
        stream.flush()  # otherwise both processes would write the buffered output
    answer, end = os.pipe()
    parent = os.getpid()
    pid = fork()
    if pid == 0:
        _be_the_worker(work, end, parent)
    os.close(end)
    try:
        content = _all_of(answer)
    finally:
        os.close(answer)
        with suppress(OSError):
            os.kill(pid, signal.SIGKILL)  # it has replied, or its time has run out
        status = os.waitpid(pid, 0)[1]  # removes the child from the system's table, also if the grader is stopped
    if not content:
        return os.waitstatus_to_exitcode(status) or UNHEARD, b''
    header, loaded, body = content.split(b'\n', 2)
    _to_load.extend(loaded.decode().split())
    return int(header), body


def _load() -> None:
    """Load the modules and message classes that earlier workers had to load, so that the next worker inherits them."""
    names, _to_load[:] = list(_to_load), []
    for name in names:
        with suppress(Exception):  # the next step meets the same error
            if '/' in name:
                sys.modules[REGISTRY].underlay_registry().get(name)
            else:
                import_module(name)


def _all_of(end: int) -> bytes:
    """Return the complete answer of the worker, or b'' if it is incomplete.

    :raises Lost: if the answer has not arrived after LONGEST_S.
    """
    deadline = monotonic() + LONGEST_S
    parts: list[bytes] = []
    attend = _attending[-1] if _attending else is_readable
    while monotonic() < deadline:
        if attend(end, LOOK_S):
            data = os.read(end, CHUNK_BYTES)
            if not data:
                whole = b''.join(parts)
                return whole[:-1] if whole.endswith(b'\n') else b''
            parts.append(data)
    raise Lost(f'the process that judges was not ready after {LONGEST_S:g} s')


def _be_the_worker(work: Callable[[], Any], end: int, parent: int) -> NoReturn:
    """Do the work, and write a line with the exit code, a line with the loaded modules, the answer, and a line end."""
    code, answer, known = SHORT_OF_MEMORY, b'', {*sys.modules, *_types()}
    gc.freeze()  # a collection would copy all pages that it shares with the grader
    try:
        _limit(end, parent)
        code, answer = 0, _text(work).encode()
    except MemoryError:
        pass
    except BaseException as error:
        code, answer = BROKE, f'{type(error).__name__}: {error}'.encode('utf-8', 'replace')
    with suppress(BaseException):
        sys.stdout.flush()
    try:
        view = memoryview(b'%d\n%b\n%b\n' % (code, ' '.join(_own(known)).encode(), answer))
        while view:
            view = view[os.write(end, view) :]
    finally:
        os._exit(code)


def _own(known: set[str]) -> list[str]:
    """Return the modules of edulaunch and edugrade that were loaded after `known`, in order, and then the new stock types."""
    modules = [name for name in sys.modules if name.split('.')[0] in ('edulaunch', 'edugrade')]
    return [name for name in (*modules, *_types()) if name not in known]


def _types() -> list[str]:
    """Return the names of the stock types whose classes have been created in this process."""
    registry = sys.modules.get(REGISTRY)
    return [cls.TYPE for cls in registry.underlay_registry().classes() if hasattr(cls, 'TYPE')] if registry else []


def _text(work: Callable[[], Any]) -> str:
    return json.dumps(work(), default=str)


def _limit(end: int, parent: int) -> None:
    """Apply the limits, close the grader's open files (its lock, its runs), and make this process end when the grader ends."""
    import resource

    from .sandbox.system import PR_SET_PDEATHSIG, prctl

    with suppress(OSError):
        prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(0)
    os.closerange(3, end)
    os.closerange(end + 1, MOST_DESCRIPTORS)
    for kind, value in (
        (resource.RLIMIT_CPU, LONGEST_CPU_S),
        (resource.RLIMIT_AS, _address_space() + MOST_MEMORY_MIB * MEBI),
        (resource.RLIMIT_CORE, 0),
    ):
        hard = resource.getrlimit(kind)[1]
        with suppress(ValueError, OSError):  # some systems lack a limit
            resource.setrlimit(kind, (value if hard == resource.RLIM_INFINITY else min(value, hard), hard))


def _address_space() -> int:
    """Return the size of this process's address space in bytes, or 0 on a system that does not report it."""
    with suppress(OSError, ValueError), open('/proc/self/statm') as file:
        return int(file.read().split()[0]) * os.sysconf('SC_PAGE_SIZE')
    return 0


class TooLong(Exception):
    """A piece of work has used all its processor time."""


@contextmanager
def cpu_limit(seconds: float) -> Iterator[None]:
    """Raise TooLong in this context after a number of seconds of processor time, however busy the computer is.

    The limit applies only in the main thread of a POSIX system. Python ignores an exception in a destructor or in a callback
    of a weak reference. So the timer repeats, and raises TooLong every REMIND_S until the work ends.

    :param seconds: the processor time in seconds.
    :raises TooLong: if the work needs more processor time.
    """
    if threading.current_thread() is not threading.main_thread() or not hasattr(signal, 'setitimer'):
        yield
        return

    def on_alarm(signum: int, frame: FrameType | None) -> None:
        raise TooLong(f'it took longer than {seconds:g} s of processor time')

    def report(ignored: sys.UnraisableHookArgs) -> None:
        if not isinstance(ignored.exc_value, TooLong):
            show(ignored)

    def stop() -> None:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
        sys.unraisablehook = show

    show, sys.unraisablehook = sys.unraisablehook, report
    before = signal.signal(signal.SIGPROF, on_alarm)
    try:
        signal.setitimer(signal.ITIMER_PROF, seconds, REMIND_S)
        try:
            yield
        finally:
            stop()
    finally:
        stop()  # again, in case TooLong was raised inside the first call
