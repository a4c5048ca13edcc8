"""Stops programs that never end their turn, such as `while True: pass`.

A separate thread checks from time to time which code the simulation's thread runs. Nothing is counted while programs run, so the
watchdog does not slow them down. It measures the processor time of a turn, so that a busy computer does not cause it to stop a
program.
"""

from __future__ import annotations

import signal
import sys
import threading
import time
import weakref
from contextlib import suppress
from types import FrameType
from typing import Any, NamedTuple

from edulaunch.engine.processes.frame_owner import is_library, is_own
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import Task, task_around

LOOKS = 8
"""The least number of consecutive observations of a turn before its program is stopped."""
WORKING = 3
IN_LIBRARY = 5
ASLEEP = 10
"""The factors by which a turn may last longer if variables change, if a library works (or is being imported), and in real
time.
"""
_WAKE = getattr(signal, 'SIGURG', None)
"""The signal that interrupts a call of the system; without a handler it does nothing."""
STARVED = 40
"""The same factor in real time for a turn that computes, because a busy machine may give it little processor time."""
IDLE = 4
"""A turn with less than this part of its processor time waits in a call of the operating system."""
PAUSES_S = (0.01, 0.03, 0.1, 0.3)
"""Pauses between attempts to start the thread, for a computer that has no threads left for a moment."""
VALUES = frozenset({int, float, bool, str, bytes, complex})
CONTAINERS = frozenset({list, dict, set, tuple, bytearray})


class RunawayProgram(BaseException):
    """Raised at any line inside a program that has run for too long without yielding; `except Exception` does not catch it.

    :param did: the rest of a sentence after the program's name.
    :param counted: whether a count stopped the program. A count repeats exactly in each run, but a measured duration does
        not.
    """

    def __init__(self, did: str = 'ran for too long', *, counted: bool = False) -> None:
        super().__init__(did)
        self.counted = counted


class BlockedProgram(RunawayProgram):
    """Raised inside a program that waits too long in a call of the operating system, such as `accept()` of a socket."""

    def __init__(self, did: str = 'waited for too long for something outside the simulation') -> None:
        super().__init__(did)


class Turn(NamedTuple):
    """One observation: the running task, the start of its turn, and the variables of the innermost function of the student's
    code. While that function waits for a library, `state` has the value None.
    """

    task: Task
    since_ns: int
    state: Any


class Watchdog:
    """The watchdog of one simulation.

    :param sim: the simulation.
    :param seconds: the processor time that a turn may take without a change in the variables of the student's function. With
        changes, a turn may take several times as long.
    :ivar thread: the identifier of the thread in which the simulation runs, or None before the first program runs.
    :ivar asleep: whether a program waits for a person at a real keyboard, which may take any time.
    """

    def __init__(self, sim: Simulation, seconds: float) -> None:
        self.seconds = seconds
        self.thread: int | None = None
        self.asleep = False
        self._sim = weakref.ref(sim)
        self._over = threading.Event()
        self._started = False

    def start(self) -> None:
        """Start watching, unless the watchdog has been started already. In a browser without threads, do nothing.

        :raises RuntimeError: if the computer cannot start a thread for almost half a second.
        """
        if self._started or sys.platform == 'emscripten':
            return
        self._started = True
        in_main = threading.current_thread() is threading.main_thread()
        if _WAKE is not None and in_main and signal.getsignal(_WAKE) is signal.SIG_DFL:
            signal.signal(_WAKE, lambda *_: None)
        for pause in PAUSES_S:
            with suppress(RuntimeError):
                self._new_thread().start()
                return
            time.sleep(pause)
        self._new_thread().start()

    def _new_thread(self) -> threading.Thread:
        return threading.Thread(target=self._watch, name='edulaunch watchdog', daemon=True)

    def stop(self) -> None:
        """Stop watching."""
        self._over.set()

    def _watch(self) -> None:
        if hasattr(signal, 'pthread_sigmask'):
            # The signal that ends a long call reports the frame of the thread that receives it, so this thread must not receive
            # it.
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGXCPU})
        seen: Turn | None = None
        began_s = changed_s = 0.0
        looks = same = 0
        while not self._over.wait(self.seconds / LOOKS):
            before, seen, now_s = seen, self._look(), self._processor_s()
            if seen is None or before is None or before[:2] != seen[:2]:
                began_s = changed_s = now_s
                looks = same = 0
                continue
            looks, same = looks + 1, same + 1
            if seen.state is None or seen.state != before.state:
                changed_s, same = now_s, 0
            most = self.seconds * (IN_LIBRARY if seen.state is None else WORKING)
            is_still = same >= LOOKS and now_s - changed_s >= self.seconds
            is_idle = now_s - began_s < self.seconds / IDLE
            longest = LOOKS * (ASLEEP if is_idle else STARVED)
            if is_still or (looks >= LOOKS and now_s - began_s >= most) or looks >= longest:
                self._end(seen.task, BlockedProgram if is_idle else RunawayProgram)
                seen = None

    def _end(self, task: Task, kind: type[RunawayProgram]) -> None:
        import ctypes

        if self._running()[0] is task:
            # This thread has just received the interpreter lock, and keeps it longer than these two lines take.
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self.thread or 0), ctypes.py_object(kind))
            if _WAKE is not None and self.thread is not None and callable(signal.getsignal(_WAKE)):
                signal.pthread_kill(self.thread, _WAKE)  # only a signal ends a call of the operating system

    def _look(self) -> Turn | None:
        """Return the current turn. Return None if the hub runs, or if a program waits for a person."""
        sim = self._sim()
        if sim is None:
            self.stop()
            return None
        task, frame = self._running()
        if task is None or self.asleep:
            return None
        while frame is not None and not is_own(frame.f_code.co_filename):
            if is_library(frame.f_code.co_filename):
                return Turn(task, sim.now_ns, None)
            frame = frame.f_back
        return Turn(task, sim.now_ns, frame and (id(frame), *map(_held, list(frame.f_locals.values()))))

    def _running(self) -> tuple[Task | None, FrameType | None]:
        """Return the task whose turn it is, and the top frame of the simulation's thread.

        The bottom of the thread's stack shows which task this is.
        """
        top = sys._current_frames().get(self.thread or 0)
        task = task_around(top)
        return (None, None) if task is None else (task, top)

    def _processor_s(self) -> float:
        """Return the processor time of the simulation's thread, in seconds.

        If the system does not report it, return the processor time of all threads.
        """
        try:
            return time.clock_gettime(time.pthread_getcpuclockid(self.thread or 0))
        except (AttributeError, OSError):
            return time.process_time()


def _held(value: Any, deep: bool = True) -> Any:
    """Return a value that stays equal as long as a variable does not change: a number itself, or the identities of an object's
    parts.

    No code of the object runs.
    """
    kind = type(value)
    if kind in VALUES:
        return value
    if kind in CONTAINERS:
        return id(value), len(value)
    try:
        attributes = object.__getattribute__(value, '__dict__') if deep else {}
    except AttributeError:
        attributes = {}
    return id(value), *(_held(item, False) for item in list(dict.values(attributes) if type(attributes) is dict else ()))
